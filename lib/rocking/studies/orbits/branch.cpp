#include "rocking/studies/orbits/branch.hpp"

namespace rocking {

std::string_view to_string(BifurcationKind kind) {
  switch (kind) {
    case BifurcationKind::fold: return "fold";
    case BifurcationKind::period_doubling: return "period_doubling";
    case BifurcationKind::symmetry_breaking: return "symmetry_breaking";
    case BifurcationKind::grazing: return "grazing";
    case BifurcationKind::contact_change: return "contact_change";
  }
  return "";
}

std::string_view to_string(BranchEnd end) {
  switch (end) {
    case BranchEnd::range: return "range";
    case BranchEnd::joins: return "joins";
    case BranchEnd::grazing: return "grazing";
    case BranchEnd::contact_change: return "contact_change";
    case BranchEnd::last_point: return "last_point";
    case BranchEnd::closed: return "closed";
    case BranchEnd::known: return "known";
    case BranchEnd::points: return "points";
  }
  return "";
}

}  // namespace rocking
