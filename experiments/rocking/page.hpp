#pragma once

#include "analysis/run_report.hpp"
#include "output.hpp"
#include "run_folder.hpp"

namespace rocking::program {

/// Writes the page of a report into its folder; says where its pictures could not be drawn, unless it is to be quiet. Throws
/// base::Stopped when a signal asks to stop, std::system_error where the page cannot be written.
void write_page(const RunFolder& folder, const analysis::RunReport& report, const Loudness& loudness);

}  // namespace rocking::program
