#pragma once

#include "rocking/api/run.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/output/write_report.hpp"

namespace rocking {

/// What a file says of the system.
[[nodiscard]] inline SystemFacts facts_of(const Occasion& occasion) {
  return {.build = base::build_info(),
          .machine = occasion.machine,
          .start = occasion.start,
          .duration_s = occasion.duration_s,
          .threads = occasion.threads};
}

}  // namespace rocking
