#pragma once

#include <string>

#include "rocking/base/build_info.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

/// The origin of a result.
namespace rocking {

/// What was asked.
struct InputFacts {
  Json experiment;     ///< canonical; null if it was made in C++
  std::string sha256;  ///< of its text, in hexadecimal digits

  [[nodiscard]] std::string title() const { return experiment.is_null() ? "" : experiment.at("title"); }
};

[[nodiscard]] InputFacts input_of(const Experiment& experiment);

/// Facts that may differ between two equal runs. The caller provides them; the library does not read them itself.
struct SystemFacts {
  base::BuildInfo build;
  std::string machine;      ///< processor and operating system
  std::string start;        ///< ISO 8601 in UTC, as `2012-02-01T12:00:00Z`
  double duration_s = 0.0;  ///< wall-clock time of the run [s]
  unsigned threads = 1;
};

}  // namespace rocking
