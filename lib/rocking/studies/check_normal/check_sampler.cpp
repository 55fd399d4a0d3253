#include "rocking/studies/check_normal/check_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/math/distributions/normal.hpp>

#include "rocking/random/draws.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/stats/law_check.hpp"

namespace rocking {

bool is_sampler(std::string_view name) { return random::sampler_from_string(name).has_value(); }

namespace {

/// The normal number from which a number follows, by other formulas than those that gave it.
std::function<double(double)> score_under(const SamplerQuestion& question) {
  const double mean = question.law.mean;
  const double sigma = question.law.sigma;
  if (question.distribution == FluctuationLaw::uniform) {
    const double half_width = std::sqrt(3.0) * sigma;
    return [mean, half_width](double x) {
      const double share = std::clamp(0.5 + 0.5 * (x - mean) / half_width, 0x1p-60, 1.0 - 0x1p-53);
      return -boost::math::quantile(boost::math::complement(boost::math::normal(), share));
    };
  }
  const double variance = std::log1p(sigma * sigma / (mean * mean));
  return [centre = std::log(mean) - 0.5 * variance, deviation = std::sqrt(variance)](double x) {
    return x > 0.0 ? (std::log(x) - centre) / deviation : -40.0;
  };
}

}  // namespace

std::optional<stats::NormalCheck> check_sampler(const SamplerQuestion& question) {
  const random::SamplerKind kind = random::sampler_from_string(question.sampler).value();
  const RedrawnQuantity law = law_along_the_way(question.distribution, question.law.mean, question.law.sigma);
  const auto drawn = [&](std::uint64_t realisation, random::Source source) {
    auto numbers = random::standard_sample(kind, {question.seed, realisation}, source, question.n);
    for (double& number : numbers) number = value_at_normal(law, number);
    return numbers;
  };
  const auto sample = drawn(0, random::Source::check_normal);
  const auto of_next_realisation = drawn(1, random::Source::check_normal);
  const auto of_next_source = drawn(0, random::Source::slip_rate);
  const stats::NormalSamples samples{sample, of_next_realisation, of_next_source};
  if (question.distribution == FluctuationLaw::normal) return stats::check_normal(samples, question.law);
  return stats::check_law(samples, {.mean = question.law.mean,
                                    .sigma = question.law.sigma,
                                    .at = [&law](double z) { return value_at_normal(law, z); },
                                    .score = score_under(question)});
}

}  // namespace rocking
