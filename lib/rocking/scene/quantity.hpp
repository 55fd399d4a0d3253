#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace rocking {

/// How a number is called in tables and figures. Its unit follows from its key.
struct NamedPlace {
  std::string_view place = "";   ///< JSON pointer into an experiment file
  std::string_view name = "";    ///< in words
  std::string_view symbol = "";  ///< a `_` begins a subscript; may be empty
};

/// An interval that contains every value of a quantity.
struct Reach {
  double least = 0.0;
  double largest = 0.0;
  friend bool operator==(const Reach&, const Reach&) = default;
};

/// The number of which a law is a function: uniform in [0, 1), or from N(0, 1) by Box and Muller.
enum class BasicDraw : std::uint8_t { uniform, normal };

/// Every value in [low, high) is equally likely: low + (high - low) u.
struct Uniform {
  static constexpr std::string_view name = "uniform";
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] static BasicDraw drawn_from() { return BasicDraw::uniform; }
  [[nodiscard]] double at(double u) const { return low + (high - low) * u; }
  [[nodiscard]] double expected() const { return 0.5 * (low + high); }
  [[nodiscard]] Reach reach() const { return {low, high}; }
  void divide(double divisor);
  friend bool operator==(const Uniform&, const Uniform&) = default;
};

/// N(mean, sigma^2): mean + sigma z. `between`: truncated, drawn by inversion of the distribution function, so that no
/// value is clamped.
struct Normal {
  static constexpr std::string_view name = "normal";
  double mean = 0.0;   ///< of the law before it is truncated
  double sigma = 0.0;  ///< likewise
  std::optional<Reach> between = std::nullopt;

  [[nodiscard]] BasicDraw drawn_from() const { return between ? BasicDraw::uniform : BasicDraw::normal; }
  [[nodiscard]] double at(double draw) const;
  [[nodiscard]] double expected() const;
  /// Without `between` the mean and 8.6 standard deviations on both sides. No draw lies farther out: Box and Muller's
  /// radius of the smallest uniform number, 2^-53, is sqrt(-2 ln 2^-53) = 8.572.
  [[nodiscard]] Reach reach() const;
  void divide(double divisor);
  friend bool operator==(const Normal&, const Normal&) = default;
};

/// The logarithm is normal: exp(m + s z), with s^2 = ln(1 + (sigma/mean)^2) and m = ln(mean) - s^2/2.
struct Lognormal {
  static constexpr std::string_view name = "lognormal";
  double mean = 1.0;   ///< of the number itself, positive
  double sigma = 0.0;  ///< its standard deviation

  [[nodiscard]] static BasicDraw drawn_from() { return BasicDraw::normal; }
  [[nodiscard]] double at(double z) const;
  [[nodiscard]] double expected() const { return mean; }
  [[nodiscard]] Reach reach() const;
  void divide(double divisor);
  friend bool operator==(const Lognormal&, const Lognormal&) = default;
};

/// The density rises linearly from `low` to `mode` and falls to `high`; drawn by inversion.
struct Triangular {
  static constexpr std::string_view name = "triangular";
  double low = 0.0;
  double mode = 0.0;
  double high = 0.0;

  [[nodiscard]] static BasicDraw drawn_from() { return BasicDraw::uniform; }
  [[nodiscard]] double at(double u) const;
  [[nodiscard]] double expected() const { return (low + mode + high) / 3.0; }
  [[nodiscard]] Reach reach() const { return {low, high}; }
  void divide(double divisor);
  friend bool operator==(const Triangular&, const Triangular&) = default;
};

/// One of these values, chosen at random.
struct Values {
  static constexpr std::string_view name = "values";
  std::vector<double> values;
  std::vector<double> weights = {};  ///< relative frequencies; empty: all are equally likely

  [[nodiscard]] static BasicDraw drawn_from() { return BasicDraw::uniform; }
  [[nodiscard]] double at(double u) const;
  [[nodiscard]] double expected() const;
  [[nodiscard]] Reach reach() const;
  void divide(double divisor);
  friend bool operator==(const Values&, const Values&) = default;
};

/// The alternatives of a Quantity. Every law has `name`, its key in files;
/// drawn_from() and at(draw), the value as a function of that number; expected(), its mean; reach(); and
/// divide(divisor), which divides every value. Its keys: keys_of_law. The bits of a value are the same on every machine.
using NumberOrLaw = std::variant<double, Uniform, Normal, Lognormal, Triangular, Values>;

/// A number, or the law from which each realisation draws it once, at its start.
struct Quantity : NumberOrLaw {
  using NumberOrLaw::NumberOrLaw;
  template <std::integral Integer>
  Quantity(Integer number) : NumberOrLaw(static_cast<double>(number)) {}
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// The same of a number that is drawn again and again along the way.
using RedrawnQuantity = std::variant<double, Uniform, Normal, Lognormal>;

/// Whether it has a law.
[[nodiscard]] inline bool is_drawn(const Quantity& quantity) { return quantity.index() != 0; }
[[nodiscard]] inline bool is_drawn(const RedrawnQuantity& quantity) { return quantity.index() != 0; }

/// Of a law; BasicDraw::uniform of a number.
[[nodiscard]] BasicDraw drawn_from(const Quantity& quantity);
[[nodiscard]] double value_at(const Quantity& quantity, double draw);
/// The value at a number from N(0, 1), also of a law that is a function of a uniform number: at the probability of z.
[[nodiscard]] double value_at_normal(const RedrawnQuantity& quantity, double z);

[[nodiscard]] Reach reach_of(const Quantity& quantity);

/// Mean of the law, or the number itself.
[[nodiscard]] double mean_of(const Quantity& quantity);

/// Every value over a divisor.
[[nodiscard]] Quantity divided(Quantity quantity, double divisor);

}  // namespace rocking
