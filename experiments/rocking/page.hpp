#pragma once

#include "drawing.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/output/report.hpp"

namespace rocking::program {

/// Writes the page of a report into its folder. Returns which pictures could not be drawn; the page omits them.
/// Throws base::Stopped when a signal asks to stop, std::system_error where the page cannot be written.
[[nodiscard]] DrawingFailures write_page(const RunFolder& folder, const Report& report,
                                         const std::optional<HazardCurve>& hazard = std::nullopt);

}  // namespace rocking::program
