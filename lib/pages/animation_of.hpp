#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "analysis/page/animation.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking::pages {

/// What is shown of a realisation.
struct AnimationExtent {
  std::int64_t periods = 1;               ///< computed, from the start; at least 1
  std::int64_t shown_periods = 1;         ///< the last ones, if the excitation is periodic; otherwise all are shown
  std::size_t most_samples = 1;           ///< of what is shown
  std::optional<int> samples_per_period;  ///< absent: as many as the eye needs
  base::StopRequest stop = {};
};

/// A realisation as a page animates it, computed again from its seed. Absent if it ends before there are two samples.
/// Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<analysis::Animation> animation_of(const Experiment& experiment, const RealisationKey& key,
                                                              const AnimationExtent& extent);

/// Periods to show of a response: a few of its own periods.
[[nodiscard]] std::int64_t shown_periods(const section::ResponseMode& mode);

}  // namespace rocking::pages
