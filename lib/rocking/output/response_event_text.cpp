#include "rocking/output/response_event_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/fields/written_types.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {
namespace {

struct Described {
  std::string_view name;
  std::string_view unit;                  ///< of the threshold; empty: none
  std::array<std::string_view, 3> verbs;  ///< does, do, did
  std::string_view beyond;                ///< between the verb and the threshold
  std::string_view after;                 ///< behind the threshold, with the verb
  std::string_view noun;                  ///< before the threshold
};

/// By EventName.
constexpr std::array described{
    Described{"overturning", "", {"overturns", "overturn", "overturned"}, "", "", "overturning"},
    Described{"tilt", "psi", {"tilts", "tilt", "tilted"}, " beyond ", "", "a peak tilt above "},
    Described{"slip", "m", {"slides", "slide", "slid"}, " more than ", "", "sliding more than "},
    Described{"displacement", "m", {"ends", "end", "ended"}, " more than ", " away", "a displacement above "},
};

const Described& description_of(const ResponseEvent& event) { return described[static_cast<std::size_t>(event.name)]; }

constexpr double degree = std::numbers::pi / 180.0;

/// By TiltUnit.
constexpr std::array<std::string_view, 3> tilt_units{"psi", "rad", "deg"};
constexpr std::string_view all_tilts = "write `tilt > 0.5 psi` (1 psi is balance), `tilt > 0.1 rad` or `tilt > 5 deg`";

std::string_view name_of(TiltUnit unit) { return tilt_units[static_cast<std::size_t>(unit)]; }

/// As it was asked for.
std::string threshold_in_words(const ResponseEvent& event, std::string (*words)(double)) {
  if (event.asked) return words(event.asked->value) + ' ' + std::string(name_of(event.asked->unit));
  return words(event.threshold) + ' ' + std::string(description_of(event).unit);
}

std::string threshold_in_words(const ResponseEvent& event) {
  return threshold_in_words(event, [](double number) { return base::significant(number, 6); });
}

std::string with_verb(const ResponseEvent& event, std::size_t form) {
  const Described& words = description_of(event);
  const std::string verb(words.verbs[form]);
  if (event.is_overturning()) return verb;
  return verb + std::string(words.beyond) + threshold_in_words(event) + std::string(words.after);
}

std::string example_of(const Described& words) {
  if (words.beyond.empty()) return std::string(words.name);
  return std::string(words.name) + (words.unit == "m" ? " > 0.05 m" : " > 0.5 psi");
}

std::string all_examples() {
  std::string text;
  for (const Described& words : described) text += (text.empty() ? "" : ", ") + ('`' + example_of(words) + '`');
  return text;
}

bool is_threshold(double number) { return number >= 0.0 && number <= 1e9; }

std::variant<ResponseEvent, NoEvent> with_tilt(double threshold, std::string_view unit) {
  const auto* const found = std::ranges::find(tilt_units, unit);
  if (unit.empty()) return NoEvent{"lacks its unit", std::string(all_tilts)};
  if (found == tilt_units.end()) return NoEvent{"has no known unit of a tilt", std::string(all_tilts)};
  if (unit == "psi" && threshold > 1.0)
    return NoEvent{"lies beyond balance, which is at 1 psi", std::string(all_tilts)};
  if (unit == "psi") return ResponseEvent{EventName::tilt, threshold};
  return ResponseEvent{EventName::tilt, threshold,
                       AskedTilt{.value = threshold, .unit = static_cast<TiltUnit>(found - tilt_units.begin())}};
}

/// Reads what follows `>`.
std::variant<ResponseEvent, NoEvent> with_threshold(EventName name, std::string_view text) {
  const Described& words = described[static_cast<std::size_t>(name)];
  const std::string remedy = "write `" + example_of(words) + '`';
  double threshold = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threshold);
  if (error != std::errc()) return NoEvent{"lacks a number after >", remedy};
  if (!is_threshold(threshold)) return NoEvent{"must exceed a number of at least 0, at most 1e9", remedy};
  const std::string_view unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  if (name == EventName::tilt) return with_tilt(threshold, unit);
  if (unit == words.unit) return ResponseEvent{name, threshold};
  return NoEvent{unit.empty() ? "lacks its unit, m" : "must be in m", remedy};
}

class EventTextType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return event_text(*static_cast<const ResponseEvent*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    if (!json.is_string()) return place.reject(json, "must be a text", "write " + all_examples());
    const auto found = read_event(json.get<std::string>());
    if (const auto* wrong = std::get_if<NoEvent>(&found)) return place.reject(json, wrong->reason, wrong->remedy);
    *static_cast<ResponseEvent*>(value) = std::get<ResponseEvent>(found);
  }
  void check(const void* value, const ReadingPlace& place) const override {
    const auto& event = *static_cast<const ResponseEvent*>(value);
    if (!event.is_overturning() && !is_threshold(event.threshold))
      place.reject(Json(base::shortest(event.threshold)), "must be at least 0, at most 1e9");
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "string"}}; }
};

template <EventName name>
class ThresholdType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& event = *static_cast<const ResponseEvent*>(value);
    return event.name == name ? Json(event.threshold) : Json();
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::optional<double> threshold;
    type_of<std::optional<double>>().read(json, place, &threshold);
    if (threshold) *static_cast<ResponseEvent*>(value) = {name, *threshold};
  }
  void check(const void* value, const ReadingPlace& place) const override {
    const auto& event = *static_cast<const ResponseEvent*>(value);
    if (event.name == name) type_of<double>().check(&event.threshold, place);
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<std::optional<double>>().schema(rule); }
};

}  // namespace

std::string event_text(const ResponseEvent& event) {
  const Described& words = description_of(event);
  if (event.is_overturning()) return std::string(words.name);
  return std::string(words.name) + " > " + threshold_in_words(event, base::shortest);
}

ResponseEvent in_units_of_balance(const ResponseEvent& event, const std::vector<Condition>& conditions) {
  if (!event.asked) return event;
  const auto refuse = [&event](std::string reason, std::string remedy) {
    throw base::InputError({"events", event_text(event), std::move(reason), std::move(remedy)});
  };
  const double tilt = event.asked->value * (event.asked->unit == TiltUnit::deg ? degree : 1.0);
  std::optional<BalanceAngles> balance;
  bool are_sides_alike = true;
  for (const Condition& condition : conditions) {
    const BalanceAngles own = balance_of(condition.scene);
    balance = joined(balance, own);
    are_sides_alike = are_sides_alike && own.least == own.largest;
  }
  const BalanceAngles& angles = balance.value();
  const auto shown = [](double number) { return base::significant(number, 3); };
  const double share = tilt / angles.least, least_share = tilt / angles.largest;
  if (least_share > 1.0) {
    refuse("lies beyond balance, which this block has at " + base::significant(angles.largest / degree, 4) +
               " deg = " + base::significant(angles.largest, 4) + " rad",
           "ask for less, or for overturning");
  }
  if (angles.is_of_mean_block || angles.least != angles.largest) {
    refuse("is not one share of balance: the blocks of the run, or their sides, have several angles psi",
           "ask for it in psi, as `tilt > " + shown(share > 1.0 ? least_share : share) + " psi`: it is " +
               shown(share) +
               (share == least_share ? " psi of the mean block"
                                     : " psi of the side that balances at the least tilt, " + shown(least_share) +
                                           " psi of that at the largest") +
               (angles.is_of_mean_block || !are_sides_alike ? "" : "; or make a run for each block"));
  }
  return {EventName::tilt, share, event.asked};
}

void check_friction(const ResponseEvent& event, const Condition& condition) {
  if (!event.is_of_slip() || condition.scene.friction) return;
  throw base::InputError({"event", event_text(event), "cannot happen but by overturning: the block has no friction",
                          "add `friction` to the experiment, or ask for overturning or a tilt"});
}

std::variant<ResponseEvent, NoEvent> read_event(std::string_view text) {
  const std::size_t sign = text.find('>');
  const std::string_view name = trimmed(text.substr(0, sign));
  const auto* const found = std::ranges::find(described, name, &Described::name);
  if (found == described.end()) return NoEvent{"is no event", "write one of " + all_examples()};
  const auto event = static_cast<EventName>(found - described.begin());
  const bool has_threshold = sign != std::string_view::npos;
  if (event == EventName::overturning) {
    if (has_threshold) return NoEvent{"has no threshold", "write `overturning`, or `tilt > 0.5 psi`"};
    return ResponseEvent{};
  }
  if (!has_threshold) return NoEvent{"lacks its threshold", "write `" + example_of(*found) + '`'};
  return with_threshold(event, trimmed(text.substr(sign + 1)));
}

const ValueType& event_text_type() { return the_only<EventTextType>(); }

const ValueType& threshold_type(EventName name) {
  switch (name) {
    case EventName::slip: return the_only<ThresholdType<EventName::slip>>();
    case EventName::displacement: return the_only<ThresholdType<EventName::displacement>>();
    default: break;
  }
  return the_only<ThresholdType<EventName::tilt>>();
}

std::string words_of(const ResponseEvent& event) {
  const std::string noun(description_of(event).noun);
  return event.is_overturning() ? noun : noun + threshold_in_words(event);
}

std::string column_of(const ResponseEvent& event) {
  if (event.is_overturning()) return "overturned";
  return std::string(description_of(event).name) + " > " + threshold_in_words(event);
}

std::string does(const ResponseEvent& event) { return with_verb(event, 0); }
std::string to_do(const ResponseEvent& event) { return with_verb(event, 1); }
std::string did(const ResponseEvent& event) { return with_verb(event, 2); }

std::string in_degrees(const ResponseEvent& event, const std::optional<BalanceAngles>& balance) {
  if (event.name != EventName::tilt || event.asked || !balance) return "";
  NumberRange tilts;
  for (const double psi : {balance->least, balance->largest}) tilts.add(event.threshold * psi / degree);
  return " (" + tilts.text() + " degrees" + (balance->is_of_mean_block ? " of the mean block)" : ")");
}

}  // namespace rocking
