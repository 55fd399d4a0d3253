#include "rocking/experiment/record.hpp"

namespace rocking::experiment {

base::Sha256 digest_of(const Record& record, std::uint64_t realisation) {
  base::Sha256Builder builder;
  builder.add(realisation);
  builder.add(to_string(record.termination));
  builder.add(to_string(record.verdict.mode));
  for (const section::StrobePoint& point : record.strobe) {
    builder.add(point.tilt);
    builder.add(point.tilt_rate);
    builder.add(point.slip_rate);
  }
  for (const std::uint64_t count : record.effort.events) builder.add(count);
  return builder.finish();
}

}  // namespace rocking::experiment
