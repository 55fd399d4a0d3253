#pragma once

#include <optional>

#include "rocking/realisation/start.hpp"

namespace rocking {

/// Excitations of realisations, one after another. Those with equal blocks share the knots of a ground motion.
class SharedExcitation {
 public:
  /// As excitation_of.
  [[nodiscard]] const dynamics::Excitation& of(const Scene& scene, const Beginning& beginning) {
    const double p = beginning.setting.block.frequency_parameter;
    const double frequency = beginning.clock.frequency();
    const double start = beginning.clock.start();
    const double size = beginning.excitation_size;
    const bool is_known = last_ && last_->asked == scene.excitation && last_->frequency_parameter == p &&
                          last_->frequency == frequency && last_->start == start;
    if (!is_known) {
      last_ = Last{scene.excitation, p, frequency, start, size, excitation_of(scene, beginning)};
    } else if (last_->size != size) {
      last_->size = size;
      last_->excitation = with_size(last_->excitation, size);
    }
    return last_->excitation;
  }

 private:
  struct Last {
    Excitation asked;
    double frequency_parameter;  ///< p
    double frequency;            ///< of the clock [-]
    double start;                ///< of the clock, tau
    double size;                 ///< that was drawn
    dynamics::Excitation excitation;
  };

  /// The same shaking with another size; kinds that hold none stay as they are.
  static dynamics::Excitation with_size(const dynamics::Excitation& excitation, double size) {
    return excitation.visit([size](const auto& kind) -> dynamics::Excitation {
      if constexpr (requires { kind.scaled(size); }) {
        return kind.scaled(size);
      } else {
        return kind;
      }
    });
  }

  std::optional<Last> last_;
};

}  // namespace rocking
