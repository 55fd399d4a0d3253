#pragma once

#include "rocking/fields/value_type.hpp"
#include "rocking/studies/infer/result.hpp"

namespace rocking {

/// Reports lists that do not have one entry for each unknown, condition or group, groups that are none of response
/// modes, and a part of an answer.
void check_infer_report(const InferReport& report, const ReadingPlace& place);

}  // namespace rocking
