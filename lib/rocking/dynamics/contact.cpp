#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

std::string_view to_string(ContactState state) {
  switch (state) {
    case ContactState::rest: return "rest";
    case ContactState::slide: return "slide";
    case ContactState::rock: return "rock";
    case ContactState::rock_slide: return "rock_slide";
    case ContactState::overturned: return "overturned";
  }
  return "";
}

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::lift: return "lift";
    case EventKind::impact_stick: return "impact_stick";
    case EventKind::impact_slip: return "impact_slip";
    case EventKind::slip_start: return "slip_start";
    case EventKind::slip_stop: return "slip_stop";
    case EventKind::slip_reverse: return "slip_reverse";
    case EventKind::slide_start: return "slide_start";
    case EventKind::slide_stop: return "slide_stop";
    case EventKind::to_rest: return "to_rest";
    case EventKind::to_slide: return "to_slide";
    case EventKind::tip: return "tip";
    case EventKind::past_balance: return "past_balance";
    case EventKind::overturn: return "overturn";
  }
  return "";
}

}  // namespace rocking::dynamics
