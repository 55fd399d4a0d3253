#include "rocking/random/sampler.hpp"

#include <array>

#include <boost/math/distributions/normal.hpp>
#include <boost/random/normal_distribution.hpp>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/random/engine.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

constexpr std::array all_samplers{SamplerKind::box_muller, SamplerKind::ziggurat, SamplerKind::inverse_cdf};

void fill_by_box_muller(std::vector<double>& sample, const Draws& draws) {
  for (std::size_t i = 0; i < sample.size(); i += 2) {
    const NormalPair pair = draws.standard_normal_pair(Source::check_normal, i / 2);
    sample[i] = pair[i];
    if (i + 1 < sample.size()) sample[i + 1] = pair[i + 1];
  }
}

void fill_by_ziggurat(std::vector<double>& sample, const Draws& draws) {
  PhiloxEngine engine(draws, Source::check_normal);
  boost::random::normal_distribution<double> normal;
  for (double& value : sample) value = normal(engine);
}

void fill_by_inverse_cdf(std::vector<double>& sample, const Draws& draws) {
  const boost::math::normal_distribution<double> normal;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    sample[i] = quantile(normal, uniform_inside(draws.bits(Source::check_normal, i)));
  }
}

}  // namespace

std::string_view to_string(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::box_muller: return "box-muller";
    case SamplerKind::ziggurat: return "ziggurat";
    case SamplerKind::inverse_cdf: return "inverse-cdf";
  }
  return {};
}

std::optional<SamplerKind> sampler_from_string(std::string_view text) {
  for (const SamplerKind kind : all_samplers) {
    if (to_string(kind) == text) return kind;
  }
  return std::nullopt;
}

std::vector<double> sample_normal(SamplerKind kind, std::uint64_t seed, std::size_t n, double mean, double sigma) {
  ROCKING_EXPECT(sigma >= 0.0);
  std::vector<double> sample(n);
  const Draws draws(seed, 0);
  switch (kind) {
    case SamplerKind::box_muller: fill_by_box_muller(sample, draws); break;
    case SamplerKind::ziggurat: fill_by_ziggurat(sample, draws); break;
    case SamplerKind::inverse_cdf: fill_by_inverse_cdf(sample, draws); break;
  }
  for (double& value : sample) value = mean + sigma * value;
  return sample;
}

}  // namespace rocking::random
