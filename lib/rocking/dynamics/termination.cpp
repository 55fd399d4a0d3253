#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

std::optional<Termination> termination_named(std::string_view name) {
  for (const Termination termination : terminations) {
    if (to_string(termination) == name) return termination;
  }
  return std::nullopt;
}

}  // namespace rocking::dynamics
