#include "rocking/dynamics/termination.hpp"

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

}  // namespace rocking::dynamics
