#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/studies/fragility/question.hpp"

namespace rocking {

/// What became of a sheet.
struct Sheet {
  bool is_written = false;
  std::vector<std::string> not_drawn = {};  ///< why the picture, or the PDF, is missing
};

/// Writes the answer about a suite as one page of A4: HTML, or PDF by the ending of the file. `command`: makes it again.
/// Throws base::InputError without a suite that has a rate.
[[nodiscard]] Sheet write_fragility_sheet(const StoredRun& stored, const RunFragility& found, const HazardCurve& hazard,
                                          const std::filesystem::path& file, const std::string& command,
                                          base::StopRequest stop);

}  // namespace rocking
