#include "rocking/studies/check_sampler.hpp"

#include "rocking/random/draws.hpp"
#include "rocking/random/sampler.hpp"

namespace rocking {

bool is_sampler(std::string_view name) { return random::sampler_from_string(name).has_value(); }

std::optional<stats::NormalCheck> check_sampler(const SamplerQuestion& question) {
  const random::SamplerKind kind = random::sampler_from_string(question.sampler).value();
  const auto drawn = [&](std::uint64_t realisation, random::Source source) {
    auto numbers = random::standard_sample(kind, {question.seed, realisation}, source, question.n);
    for (double& number : numbers) number = question.law.mean + question.law.sigma * number;
    return numbers;
  };
  const auto sample = drawn(0, random::Source::check_normal);
  const auto of_next_realisation = drawn(1, random::Source::check_normal);
  const auto of_next_source = drawn(0, random::Source::slip_rate);
  return stats::check_normal({sample, of_next_realisation, of_next_source}, question.law);
}

}  // namespace rocking
