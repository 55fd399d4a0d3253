#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "rocking/scene/keys.hpp"
#include "rocking/scene/number_rule.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking {

/// The keys of `excitation`, kind by kind. `block`: mean block of the scene.
void keys_of(Keys& in, Excitation& excitation, const dynamics::Block& block);

/// An experiment without its sweep: one condition.
struct Question {
  std::string title;
  std::uint64_t seed = 0;
  Condition condition;
};

/// The keys of an experiment file after `format`, in the order of the canonical text. Reading, the checks of a condition
/// from C++, the schema and the table of keys in lib/docs/formats.md follow from this list. Each value stands by itself;
/// what values demand of each other: check_relations.
void keys_of(Keys& in, Question& question);

/// Names of the laws, each the key by which an object of a file gives one, in the order of NumberOrLaw after the number.
inline constexpr auto law_names = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array{std::variant_alternative_t<i + 1, NumberOrLaw>::name...};
}
(std::make_index_sequence<std::variant_size_v<NumberOrLaw> - 1>{});

/// The law with this place among the names, without its numbers.
[[nodiscard]] Quantity law_at(std::size_t place);

/// Goes through the keys of the law that the quantity has, which stand in the object that is its value. `rule` bounds
/// every value that is given, and the mean.
void keys_of_law(Keys& in, Quantity& quantity, const NumberRule& rule);

/// Why the numbers of a law are none together.
[[nodiscard]] std::optional<Refusal> refusal_of_law(const Quantity& quantity);

/// The key that gives a restitution.
void key_of(Keys& in, const Key& key, Restitution& law, Absent absent);

}  // namespace rocking
