#pragma once

#include "rocking/api/question_check.hpp"
#include "rocking/api/run.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/output/provenance.hpp"

namespace rocking {

/// What a file says of the system. Throws base::InputError for a duration that is none.
[[nodiscard]] inline SystemFacts facts_of(const Provenance& provenance) {
  check_fields(provenance);
  return {.build = base::build_info(),
          .machine = provenance.machine,
          .start = provenance.start,
          .duration_s = provenance.duration_s,
          .threads = provenance.threads};
}

}  // namespace rocking
