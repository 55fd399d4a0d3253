#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

std::string_view to_string(Termination termination) {
  switch (termination) {
    case Termination::reached_horizon: return "reached_horizon";
    case Termination::overturned: return "overturned";
    case Termination::painleve: return "painleve";
    case Termination::stopped: return "stopped";
  }
  return "";
}

std::optional<Termination> termination_named(std::string_view name) {
  for (const Termination termination : terminations) {
    if (to_string(termination) == name) return termination;
  }
  return std::nullopt;
}

}  // namespace rocking::dynamics
