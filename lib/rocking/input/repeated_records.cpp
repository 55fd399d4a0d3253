#include "rocking/input/repeated_records.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "rocking/base/number_text.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr double even_step = 0.01;          // [s]
constexpr std::size_t fewest_points = 200;  // of a series that is compared
constexpr std::size_t most_points = 16384;
constexpr double least_correlation = 0.95;
constexpr double least_of_same_header = 0.6;
constexpr double least_overlap = 0.8;         // of the energy of one of the two
constexpr double least_share = 0.05;          // of the energy of the other one
constexpr double least_alike_spectra = 0.95;  // of two series that are worth correlating
constexpr double fewest_frequencies = 10.0;   // of a series that is not narrow-band

using Spectrum = std::vector<std::complex<double>>;

/// Without the care for infinite numbers of operator*, which takes most of the time.
std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// The discrete Fourier transform in place; the length is a power of two.
void transform(Spectrum& values) {
  const std::size_t size = values.size();
  for (std::size_t i = 1, k = 0; i < size; ++i) {
    std::size_t bit = size >> 1U;
    for (; (k & bit) != 0; bit >>= 1U) k ^= bit;
    k ^= bit;
    if (i < k) std::swap(values[i], values[k]);
  }
  for (std::size_t length = 2; length <= size; length *= 2) {
    const auto turn = std::polar(1.0, -2.0 * std::numbers::pi / static_cast<double>(length));
    for (std::size_t start = 0; start < size; start += length) {
      std::complex<double> factor = 1.0;
      for (std::size_t i = start; i < start + length / 2; ++i, factor = times(factor, turn)) {
        const std::complex<double> other = times(factor, values[i + length / 2]);
        values[i + length / 2] = values[i] - other;
        values[i] += other;
      }
    }
  }
}

template <class Iterator>
Spectrum spectrum_of(Iterator begin, Iterator end, std::size_t length) {
  Spectrum spectrum(begin, end);
  spectrum.resize(length);
  transform(spectrum);
  return spectrum;
}

/// Means of the acceleration over even steps, without what its ends have of the energy and without its mean.
std::vector<double> even_means(const std::vector<dynamics::GroundMotionSample>& samples) {
  std::vector<double> means;
  const double first = samples.front().time;
  const auto count = static_cast<std::size_t>(std::min((samples.back().time - first) / even_step, 1e6));
  means.resize(count, 0.0);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double from = samples[i].time - first, to = samples[i + 1].time - first;
    const double slope = to > from ? (samples[i + 1].horizontal - samples[i].horizontal) / (to - from) : 0.0;
    for (auto k = static_cast<std::size_t>(from / even_step); k < count && static_cast<double>(k) * even_step < to;
         ++k) {
      const double low = std::max(from, static_cast<double>(k) * even_step),
                   high = std::min(to, static_cast<double>(k + 1) * even_step);
      if (high > low)
        means[k] += (high - low) / even_step * (samples[i].horizontal + slope * (0.5 * (low + high) - from));
    }
  }
  double mean = 0.0, energy = 0.0, sum = 0.0;
  for (const double value : means) mean += value / static_cast<double>(std::max<std::size_t>(count, 1));
  for (double& value : means) {
    value -= mean;
    energy += value * value;
  }
  std::size_t begin = 0, end = count;
  for (std::size_t i = 0; i < count; ++i) {
    sum += means[i] * means[i];
    if (sum < 0.005 * energy) begin = i + 1;
    if (sum < 0.995 * energy) end = i + 2;
  }
  end = std::min({end, count, begin + most_points});
  return {means.begin() + static_cast<std::ptrdiff_t>(std::min(begin, end)),
          means.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// A series, and what its comparison with others needs.
class ComparedSeries {
 public:
  explicit ComparedSeries(const GroundMotion& motion) : motion_(&motion), values_(even_means(motion.samples)) {
    for (const double value : values_) energy_.push_back(energy_.back() + value * value);
    if (size() >= fewest_points) look_at_spectrum();
  }

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] const GroundMotion& motion() const { return *motion_; }

  [[nodiscard]] bool is_compared() const { return is_broad_; }

  [[nodiscard]] bool has_spectrum_of(const ComparedSeries& other) const {
    double alike = 0.0;
    for (std::size_t i = 0; i < bands_.size(); ++i) alike += bands_[i] * other.bands_[i];
    return alike >= least_alike_spectra;
  }

  /// The largest normalised correlation over all lags, in size.
  [[nodiscard]] double correlation(const ComparedSeries& other, bool is_backwards) const {
    const std::size_t length = std::bit_ceil(size() + other.size());
    Spectrum product = spectrum_of(values_.begin(), values_.end(), length);
    const Spectrum of_other = is_backwards ? spectrum_of(other.values_.rbegin(), other.values_.rend(), length)
                                           : spectrum_of(other.values_.begin(), other.values_.end(), length);
    for (std::size_t i = 0; i < length; ++i) product[i] = times(product[i], std::conj(of_other[i]));
    transform(product);  // of the conjugate: the inverse but for signs of the imaginary parts
    const auto n = static_cast<double>(product.size());
    double best = 0.0;
    // At the lag k the other series begins k steps later: its point i + k stands beside point i.
    const auto own_size = static_cast<std::ptrdiff_t>(size()), other_size = static_cast<std::ptrdiff_t>(other.size());
    for (std::ptrdiff_t lag = 1 - own_size; lag < other_size; ++lag) {
      const auto place = static_cast<std::size_t>(lag < 0 ? lag + static_cast<std::ptrdiff_t>(product.size()) : lag);
      const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, -lag), to = std::min(own_size, other_size - lag);
      const double own = energy_between(from, to);
      const double others = is_backwards ? other.energy_between(other_size - to - lag, other_size - from - lag)
                                         : other.energy_between(from + lag, to + lag);
      const auto [less, more] = std::minmax({own / energy_.back(), others / other.energy_.back()});
      if (more < least_overlap || less < least_share) continue;
      best = std::max(best, std::abs(product[place].real()) / n / std::sqrt(own * others));
    }
    return best;
  }

 private:
  /// Zeros behind a series make neighbouring frequencies alike, so that it is looked at in a length of its own.
  void look_at_spectrum() {
    const std::size_t length = std::bit_ceil(size());
    const Spectrum spectrum = spectrum_of(values_.begin(), values_.end(), length);
    const double nyquist = static_cast<double>(length) / 2.0;
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 1; i < length / 2; ++i) {
      const double power = std::norm(spectrum[i]);
      sum += power;
      squares += power * power;
      // Bands of frequency, with equal ratios, are the same for every length.
      const double octaves = std::log2(nyquist / static_cast<double>(i));
      bands_[std::min(static_cast<std::size_t>(3.0 * octaves), bands_.size() - 1)] += power;
    }
    for (double& band : bands_) band = sum > 0.0 ? std::sqrt(band / sum) : 0.0;
    is_broad_ = squares > 0.0 &&
                sum * sum / squares * static_cast<double>(size()) >= fewest_frequencies * static_cast<double>(length);
  }
  [[nodiscard]] double energy_between(std::ptrdiff_t from, std::ptrdiff_t to) const {
    return energy_[static_cast<std::size_t>(to)] - energy_[static_cast<std::size_t>(from)];
  }

  const GroundMotion* motion_;
  std::vector<double> values_;
  std::vector<double> energy_{0.0};  ///< sums of the squares
  std::array<double, 24> bands_{};   ///< square roots of the shares of the energy
  bool is_broad_ = false;
};

bool is_named(const GroundMotion& motion) { return !motion.origin.empty() && !motion.component.empty(); }

/// Why `later` is `former` once more; empty if it is not.
std::string why_repeated(const ComparedSeries& later, const ComparedSeries& former) {
  const GroundMotion &one = later.motion(), &other = former.motion();
  if (one.name == other.name) return {};  // another component of a file, or the same one at another level
  const std::string name = brief(Json(other.name));
  const bool are_named = is_named(one) && is_named(other);
  const bool is_same = are_named && one.origin == other.origin && is_same_component(one.component, other.component);
  if (are_named && !is_same) return {};
  if (!later.is_compared() || !former.is_compared() || (!is_same && !later.has_spectrum_of(former))) return {};
  for (const bool is_backwards : {false, true}) {
    const double found = later.correlation(former, is_backwards);
    if (found < (is_same ? least_of_same_header : least_correlation)) continue;
    return "is likely the record " + name + " once more" + (is_backwards ? ", backwards" : "") +
           (is_same ? ": its header names the same earthquake, station and component, and the correlation is "
                    : ": the correlation is ") +
           base::significant(found, 3) + " at the best lag";
  }
  return {};
}

}  // namespace

std::vector<RepeatedRecord> repeated_records(const std::vector<std::shared_ptr<const GroundMotion>>& motions) {
  std::vector<ComparedSeries> all;
  for (const auto& motion : motions) all.emplace_back(*motion);
  std::vector<RepeatedRecord> repeated;
  for (std::size_t i = 1; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      std::string why = why_repeated(all[i], all[k]);
      if (why.empty()) continue;
      repeated.push_back({.record = i, .why = std::move(why)});
      break;
    }
  }
  return repeated;
}

}  // namespace rocking
