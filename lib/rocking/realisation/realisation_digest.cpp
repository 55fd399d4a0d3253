#include "rocking/realisation/realisation_digest.hpp"

namespace rocking {

base::Sha256 digest_of(const RealisationResult& result, std::uint64_t realisation) {
  base::Sha256Builder builder;
  builder.add(realisation);
  builder.add(to_string(result.termination));
  builder.add(to_string(result.classification.mode));
  for (const section::StrobePoint& point : result.strobe) {
    builder.add(point.tilt);
    builder.add(point.tilt_rate);
    builder.add(point.slip_rate);
  }
  if (result.settling && result.settling->was_continued()) builder.add(result.settling->continued);
  if (result.settling && result.settling->long_run) builder.add(to_string(*result.settling->long_run));
  for (const std::uint64_t count : result.operations.events) builder.add(count);
  return builder.finish();
}

}  // namespace rocking
