#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/draw.hpp"
#include "analysis/page/page.hpp"
#include "pages/animation_of.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/store.hpp"
#include "rocking/store/summary.hpp"

namespace rocking::pages {

/// The page of a realisation alone; 0 samples of the history: as many as the eye needs. Absent as animation_of.
[[nodiscard]] std::optional<std::string> animation_page_of(const Experiment& experiment, const RealisationKey& key,
                                                           const TrajectoryExtent& extent);

/// No motions, and why.
[[nodiscard]] analysis::ShownAnimations no_animations(const std::string& reason);

/// The motions in the page of a run: of the condition whose realisations differ most, one of each response mode. If no
/// condition has different responses, one of each response mode of the run. If this program does not give the bits of the
/// store, there are none, and the explanation says why.
[[nodiscard]] analysis::ShownAnimations animations_of(const Experiment& experiment, const Store& store,
                                                      const Report& report);

/// Writes the page of a run, with these figures and motions. Returns why pictures are missing. Throws base::Stopped if it
/// is asked to stop, std::system_error with the path where the page cannot be written.
[[nodiscard]] std::vector<analysis::Drawing> write_page(const std::filesystem::path& file, const Report& report,
                                                        std::vector<analysis::Figure> figures,
                                                        const analysis::ShownAnimations& motions,
                                                        base::StopRequest stop);

}  // namespace rocking::pages
