#include "rocking/scene/restitution.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

using dynamics::Geometry;

// e itself

double mean(const Quantity& e, const Geometry&) { return mean_of(e); }
double as_given(const Quantity& e, const Geometry&) { return mean_of(e); }
double unit(const Quantity&, const Geometry&) { return 1.0; }
std::optional<double> lognormal(const Quantity& e) { return mean_of(e); }
RestitutionNumber number(const Quantity& e) { return {.name = "restitution", .place = "/restitution", .value = &e}; }
Reach bounds(const Quantity&, const Geometry&) { return {least_restitution, largest_restitution}; }
std::optional<Refusal> refusal(const Quantity&, const ShapeRange&) { return std::nullopt; }
constexpr Form form(const Quantity*) { return {.name = "", .rule = &rules::restitution}; }
Quantity value_in(const Quantity& e) { return e; }
void set(Quantity& e, Quantity value) { e = std::move(value); }

// Jeong & Yang (2012)

double mean(const Jy25Restitution&, const Geometry& block) { return dynamics::inelastic_rate_ratio(block); }
double as_given(const Jy25Restitution& law, const Geometry& block) { return mean(law, block); }
double unit(const Jy25Restitution&, const Geometry&) { return 1.0; }
std::optional<double> lognormal(const Jy25Restitution&) { return std::nullopt; }
RestitutionNumber number(const Jy25Restitution&) { return {.name = "", .place = "/restitution", .value = nullptr}; }
Reach bounds(const Jy25Restitution&, const Geometry&) { return {least_restitution, largest_restitution}; }
std::optional<Refusal> refusal(const Jy25Restitution&, const ShapeRange&) { return std::nullopt; }
constexpr Form form(const Jy25Restitution*) { return {.name = "jy25", .rule = nullptr}; }
Quantity value_in(const Jy25Restitution&) { return 0.0; }
void set(Jy25Restitution&, const Quantity&) {}

// A measured ratio of the tilt rates

double mean(const RateRatio& ratio, const Geometry& block) {
  return dynamics::restitution_of_rate_ratio(block, mean_of(ratio.value));
}
double as_given(const RateRatio& ratio, const Geometry&) { return mean_of(ratio.value); }
double unit(const RateRatio&, const Geometry& block) { return dynamics::impact_loss(0.0, block); }
std::optional<double> lognormal(const RateRatio&) { return std::nullopt; }
RestitutionNumber number(const RateRatio& ratio) {
  return {.name = "ratio of the tilt rates at impacts", .place = "/restitution/rate_ratio", .value = &ratio.value};
}
Reach bounds(const RateRatio&, const Geometry& block) {
  return {dynamics::inelastic_rate_ratio(block, largest_restitution),
          dynamics::inelastic_rate_ratio(block, least_restitution)};
}
std::optional<Refusal> refusal(const RateRatio& ratio, const ShapeRange& shapes) {
  const auto allows = [&ratio](const dynamics::Edge& edge) {
    return rules::restitution.allows(dynamics::restitution_of_rate_ratio(edge, mean_of(ratio.value)));
  };
  const double largest = mean(ratio, shapes.most_slender);
  if (std::ranges::all_of(shapes.most_slender.edges, allows) && std::ranges::all_of(shapes.squattest.edges, allows)) {
    return std::nullopt;
  }
  const auto shown = [](double number) { return base::significant(number, 6); };
  const double least_ratio = std::max(0.0, dynamics::inelastic_rate_ratio(shapes.most_slender, 1.0));
  return Refusal{"needs a restitution e = " + shown(largest) + " for this block, which must be above -1 and at most 1",
                 "give at least 1 - 3 sin^2(psi) = " + shown(least_ratio) + " and less than 1"};
}
constexpr Form form(const RateRatio*) { return {.name = "rate_ratio", .rule = &rules::rate_ratio}; }
Quantity value_in(const RateRatio& ratio) { return ratio.value; }
void set(RateRatio& ratio, Quantity value) { ratio.value = std::move(value); }

/// In the order of the alternatives.
constexpr auto forms = []<class... Laws>(std::variant<Laws...>*) {
  return std::array{form(static_cast<const Laws*>(nullptr))...};
}(static_cast<Restitution*>(nullptr));

}  // namespace

double mean_restitution(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return mean(each, block); }, law);
}

double mean_as_given(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return as_given(each, block); }, law);
}

double unit_of(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return unit(each, block); }, law);
}

std::optional<double> lognormal_mean(const Restitution& law) {
  return std::visit([](const auto& each) { return lognormal(each); }, law);
}

RestitutionNumber number_of(const Restitution& law) {
  return std::visit([](const auto& each) { return number(each); }, law);
}

Reach bounds_of(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return bounds(each, block); }, law);
}

std::optional<Refusal> refusal_of(const Restitution& law, const ShapeRange& shapes) {
  return std::visit([&](const auto& each) { return refusal(each, shapes); }, law);
}

const FormsType& restitution_type() {
  static const FormsType type(forms,
                              "write a number, \"jy25\" for 1 - 1.5 sin^2(psi), or {\"rate_ratio\": 0.93} for a "
                              "measured ratio of the tilt rates");
  return type;
}

Formed formed(const Restitution& law) {
  return {.form = law.index(), .value = std::visit([](const auto& each) { return value_in(each); }, law)};
}

Restitution restitution_of(Formed value) {
  auto law = alternative_at<Restitution>(value.form);
  std::visit([&](auto& each) { set(each, std::move(value.value)); }, law);
  return law;
}

namespace {

/// Least share of Housner's ratio without a second sentence. Measured ratios lie above it for most blocks.
constexpr double usual_share = 0.85;

}  // namespace

void NumberRange::add(double number) {
  least = std::min(least, number);
  largest = std::max(largest, number);
}

std::string NumberRange::text() const {
  const std::string first = base::significant(least, 3);
  const std::string last = base::significant(largest, 3);
  return first == last ? first : first + " to " + last;
}

void RateRatios::add(const dynamics::Geometry& block, double restitution) {
  const double ratio = dynamics::inelastic_rate_ratio(block, restitution);
  const double housner = dynamics::inelastic_rate_ratio(block);
  restitution_.add(restitution);
  ratio_.add(ratio);
  housner_.add(housner);
  if (housner > 0.0) share_.add(ratio / housner);
}

std::string RateRatios::text() const {
  std::string text = "e = " + restitution_.text() + ": " + ratio_.text() +
                     " of the tilt rate survives an impact without slip (Housner's ratio: " + housner_.text() + ")";
  if (!(share_.least < usual_share)) return text;
  return text +
         ". This is less than 0.85 of Housner's ratio. If your number is the measured ratio of the rates, write "
         "\"restitution\": {\"rate_ratio\": 0.93}";
}

}  // namespace rocking
