#include "rocking/random/sampler.hpp"

#include <algorithm>

#include <boost/math/distributions/normal.hpp>
#include <boost/random/normal_distribution.hpp>

#include "rocking/random/draws.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

void fill_by_ziggurat(std::vector<double>& sample, PhiloxEngine engine) {
  boost::random::normal_distribution<double> normal;
  for (double& value : sample) value = normal(engine);
}

void fill_by_inverse_cdf(std::vector<double>& sample, PhiloxEngine engine) {
  const boost::math::normal_distribution<double> normal;
  for (double& value : sample) value = quantile(normal, uniform_inside(engine()));
}

}  // namespace

std::optional<SamplerKind> sampler_from_string(std::string_view text) {
  const auto found = std::ranges::find(sampler_names, text);
  if (found == sampler_names.end()) return std::nullopt;
  return static_cast<SamplerKind>(found - sampler_names.begin());
}

std::vector<double> standard_sample(SamplerKind kind, const Draws& draws, Source source, std::size_t n) {
  std::vector<double> sample(n);
  switch (kind) {
    case SamplerKind::box_muller: draws.standard_normals(source, 0, sample); break;
    case SamplerKind::ziggurat: fill_by_ziggurat(sample, {draws, source}); break;
    case SamplerKind::inverse_cdf: fill_by_inverse_cdf(sample, {draws, source}); break;
  }
  return sample;
}

}  // namespace rocking::random
