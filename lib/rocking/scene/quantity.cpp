#include "rocking/scene/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "rocking/base/elementary.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr double largest_normal_draw = 8.6;

/// Calls act(law) on the law of a quantity; gives `otherwise(number)` of a number.
template <class AnyQuantity, class Act, class Otherwise>
auto on_law(const AnyQuantity& quantity, const Act& act, const Otherwise& otherwise) {
  return std::visit(
      [&]<class Alternative>(const Alternative& alternative) {
        if constexpr (std::is_same_v<Alternative, double>) {
          return otherwise(alternative);
        } else {
          return act(alternative);
        }
      },
      quantity);
}

}  // namespace

// Uniform

void Uniform::divide(double divisor) {
  low /= divisor;
  high /= divisor;
}

namespace {

void keys_of(FieldVisitor& in, Uniform& law, const Rule& rule) {
  std::vector<double> ends{law.low, law.high};
  in.value({Uniform::name, "both ends of an interval"}, ends, NumbersType({.least = 2, .most = 2}, rule),
           Absent::error);
  if (ends.size() == 2) law = {ends[0], ends[1]};
}

std::optional<Refusal> refusal_of(const Uniform& law) {
  if (law.low < law.high) return std::nullopt;
  return Refusal{"its first end must be less than its second", "swap them, or write a number"};
}

// Normal

/// The law between its bounds: upper tails there, of the law or of its mirror image, so that they are the small ones.
struct TruncatedTails {
  bool is_mirrored;
  double at_low;
  double at_high;
};

/// The bounds in standard deviations from the mean. Their distance is not the difference of the two, which has fewer digits.
struct Scores {
  double low;
  double high;
  double width;

  [[nodiscard]] bool is_mirrored() const { return low + high < 0.0; }
  /// Below 1e-6 the difference of two tails, each with a relative error of 5e-15, loses more digits of a quantile than its
  /// expansion: the logarithm of the density is a line up to width^2/8.
  [[nodiscard]] bool is_narrow() const { return width < 1e-6; }
};

Scores scores_of(const Normal& law) {
  return {.low = (law.between->least - law.mean) / law.sigma,
          .high = (law.between->largest - law.mean) / law.sigma,
          .width = (law.between->largest - law.between->least) / law.sigma};
}

TruncatedTails tails_of(const Scores& scores) {
  const bool is_mirrored = scores.is_mirrored();
  return {is_mirrored, base::normal_upper_tail(is_mirrored ? -scores.high : scores.low),
          base::normal_upper_tail(is_mirrored ? -scores.low : scores.high)};
}

/// Of a normal number to lie between the bounds.
double probability_between(const Scores& scores) {
  if (scores.is_narrow()) return scores.width * base::normal_density(0.5 * (scores.low + scores.high));
  const TruncatedTails tails = tails_of(scores);
  return tails.at_low - tails.at_high;
}

}  // namespace

double Normal::at(double draw) const {
  if (!between) return mean + sigma * draw;
  const Scores scores = scores_of(*this);
  double value = 0.0;
  if (scores.is_narrow()) {
    // The quantile of a density exp(-slope t) in [0, 1] is u - slope u (1 - u)/2 up to slope^2/12.
    const double slope = 0.5 * (scores.low + scores.high) * scores.width;
    value = between->least + (between->largest - between->least) * (draw - 0.5 * slope * draw * (1.0 - draw));
  } else {
    const TruncatedTails tails = tails_of(scores);
    const double share = tails.is_mirrored ? 1.0 - draw : draw;  // the value rises with the draw
    const double x = base::normal_quantile_of_tail(tails.at_low - share * (tails.at_low - tails.at_high));
    value = mean + sigma * (tails.is_mirrored ? -x : x);
  }
  return std::clamp(value, between->least, between->largest);  // rounding
}

double Normal::expected() const {
  if (!between) return mean;
  const Scores scores = scores_of(*this);
  const double value = scores.is_mirrored()
                           ? between->largest - sigma * base::normal_mean_above(-scores.high, scores.width)
                           : between->least + sigma * base::normal_mean_above(scores.low, scores.width);
  return std::clamp(value, between->least, between->largest);  // rounding
}

Reach Normal::reach() const {
  if (between) return *between;
  const double farthest = largest_normal_draw * sigma;
  return {.least = mean - farthest, .largest = mean + farthest};
}

void Normal::divide(double divisor) {
  mean /= divisor;
  sigma /= divisor;
  if (between) between = Reach{between->least / divisor, between->largest / divisor};
}

namespace {

void keys_of_mean_and_sigma(FieldVisitor& in, double& mean, double& sigma, const Rule& rule) {
  in.value({"mean", "of the number"}, mean, rule, Absent::error);
  in.value({"sigma", "its standard deviation"}, sigma, rules::sigma, Absent::error);
}

void keys_of(FieldVisitor& in, Normal& law, const Rule& rule) {
  in.object({Normal::name, "mean and standard deviation"}, Absent::error, [&](FieldVisitor& keys) {
    keys_of_mean_and_sigma(keys, law.mean, law.sigma, rule);
    keys.optional("between", law.between, [&](Reach& between) {
      std::vector<double> ends{between.least, between.largest};
      keys.value({"between", "truncated to this interval"}, ends, NumbersType({.least = 2, .most = 2}, rule),
                 Absent::omitted);
      if (ends.size() == 2) between = {ends[0], ends[1]};
    });
  });
}

std::optional<Refusal> refusal_of(const Normal& law) {
  if (!law.between) return std::nullopt;
  if (!(law.between->least < law.between->largest)) {
    return Refusal{"\"between\" must have its smaller end first", "swap its ends, or write a number"};
  }
  if (law.sigma > 0.0 && probability_between(scores_of(law)) > 1e-30) return std::nullopt;
  return Refusal{"has no probability in \"between\"", "give a larger \"sigma\", or an interval that holds the mean"};
}

// Lognormal

/// Mean and standard deviation of the logarithm.
struct OfLogarithm {
  double mean;
  double sigma;
};

OfLogarithm logarithm_of(const Lognormal& law) {
  const double ratio = law.sigma / law.mean;
  const double variance = base::natural_logarithm(1.0 + ratio * ratio);
  return {base::natural_logarithm(law.mean) - 0.5 * variance, std::sqrt(variance)};
}

}  // namespace

double Lognormal::at(double z) const {
  const OfLogarithm logarithm = logarithm_of(*this);
  return base::exponential(logarithm.mean + logarithm.sigma * z);
}

Reach Lognormal::reach() const { return {.least = at(-largest_normal_draw), .largest = at(largest_normal_draw)}; }

void Lognormal::divide(double divisor) {
  mean /= divisor;
  sigma /= divisor;
}

namespace {

void keys_of(FieldVisitor& in, Lognormal& law, const Rule& rule) {
  in.object({Lognormal::name, "mean and standard deviation of the number, not of its logarithm"}, Absent::error,
            [&](FieldVisitor& keys) { keys_of_mean_and_sigma(keys, law.mean, law.sigma, rule); });
}

std::optional<Refusal> refusal_of(const Lognormal& law) {
  if (law.mean <= 0.0) return Refusal{"must have a positive mean", "give a positive mean, or another law"};
  if (law.mean < 1e-12 || law.sigma > 100.0 * law.mean) {
    return Refusal{"has a standard deviation above 100 means, or a mean below 1e-12", "give a smaller \"sigma\""};
  }
  return std::nullopt;
}

}  // namespace

// Triangular

double Triangular::at(double u) const {
  const double width = high - low;
  const double below = (mode - low) / width;  // probability below the mode
  const double value =
      u < below ? low + std::sqrt(u * width * (mode - low)) : high - std::sqrt((1.0 - u) * width * (high - mode));
  return std::clamp(value, low, high);  // rounding
}

void Triangular::divide(double divisor) {
  low /= divisor;
  mode /= divisor;
  high /= divisor;
}

namespace {

void keys_of(FieldVisitor& in, Triangular& law, const Rule& rule) {
  std::vector<double> corners{law.low, law.mode, law.high};
  in.value({Triangular::name, "smallest value, most likely value, largest value"}, corners,
           NumbersType({.least = 3, .most = 3}, rule), Absent::error);
  if (corners.size() == 3) law = {corners[0], corners[1], corners[2]};
}

std::optional<Refusal> refusal_of(const Triangular& law) {
  if (law.low <= law.mode && law.mode <= law.high && law.low < law.high) return std::nullopt;
  return Refusal{"its smallest, most likely and largest value must be in this order",
                 "sort them, or write a number where all are equal"};
}

constexpr std::size_t most_values = 10'000;

double sum_of_weights(const Values& law) { return std::accumulate(law.weights.begin(), law.weights.end(), 0.0); }

}  // namespace

// Values

double Values::at(double u) const {
  if (weights.empty()) {
    const auto place = static_cast<std::size_t>(u * static_cast<double>(values.size()));
    return values[std::min(place, values.size() - 1)];
  }
  double rest = u * sum_of_weights(*this);
  std::size_t last = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] == 0.0) continue;
    if (rest < weights[i]) return values[i];
    rest -= weights[i];
    last = i;
  }
  return values[last];  // rounding
}

double Values::expected() const {
  if (weights.empty()) return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / sum_of_weights(*this);
}

Reach Values::reach() const {
  const auto [least, largest] = std::ranges::minmax_element(values);
  return {*least, *largest};
}

void Values::divide(double divisor) {
  for (double& value : values) value /= divisor;
}

namespace {

void keys_of(FieldVisitor& in, Values& law, const Rule& rule) {
  in.value({Values::name, "the values among which one is chosen"}, law.values,
           NumbersType({.least = 1, .most = most_values}, rule), Absent::error);
  if (!in.stands("weights", !law.weights.empty())) return;
  in.value({"weights", "of each value, its relative frequency; absent: all are equally likely"}, law.weights,
           NumbersType({.least = 1, .most = most_values}, rules::weight), Absent::omitted);
}

std::optional<Refusal> refusal_of(const Values& law) {
  if (law.values.empty()) return Refusal{"has no values", "give at least one"};
  if (law.weights.empty()) return std::nullopt;
  if (law.weights.size() != law.values.size()) {
    return Refusal{
        "has " + std::to_string(law.values.size()) + " values and " + std::to_string(law.weights.size()) + " weights",
        "give one weight for each value, or none"};
  }
  if (sum_of_weights(law) > 0.0) return std::nullopt;
  return Refusal{"has no weight above 0", "give a positive weight to at least one value"};
}

}  // namespace

BasicDraw drawn_from(const Quantity& quantity) {
  return on_law(
      quantity, [](const auto& law) { return law.drawn_from(); }, [](double) { return BasicDraw::uniform; });
}

double value_at(const Quantity& quantity, double draw) {
  return on_law(
      quantity, [draw](const auto& law) { return law.at(draw); }, [](double number) { return number; });
}

double value_at_normal(const RedrawnQuantity& quantity, double z) {
  return on_law(
      quantity,
      [z](const auto& law) { return law.at(law.drawn_from() == BasicDraw::normal ? z : base::normal_upper_tail(-z)); },
      [](double number) { return number; });
}

Reach reach_of(const Quantity& quantity) {
  return on_law(
      quantity, [](const auto& law) { return law.reach(); },
      [](double number) {
        return Reach{number, number};
      });
}

double mean_of(const Quantity& quantity) {
  return on_law(
      quantity, [](const auto& law) { return law.expected(); }, [](double number) { return number; });
}

Quantity divided(Quantity quantity, double divisor) {
  std::visit(
      [divisor]<class Alternative>(Alternative& alternative) {
        if constexpr (std::is_same_v<Alternative, double>) {
          alternative /= divisor;
        } else {
          alternative.divide(divisor);
        }
      },
      quantity);
  return quantity;
}

Quantity law_at(std::size_t place) {
  Quantity law;
  static_cast<NumberOrLaw&>(law) = alternative_at<NumberOrLaw>(place + 1);
  return law;
}

void keys_of_law(FieldVisitor& in, Quantity& quantity, const Rule& rule) {
  std::visit(
      [&]<class Alternative>(Alternative& law) {
        if constexpr (!std::is_same_v<Alternative, double>) keys_of(in, law, rule);
      },
      quantity);
}

std::optional<Refusal> refusal_of_law(const Quantity& quantity) {
  return on_law(
      quantity, [](const auto& law) { return refusal_of(law); },
      [](double) -> std::optional<Refusal> { return std::nullopt; });
}

}  // namespace rocking
