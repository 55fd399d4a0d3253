#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/struct_type.hpp"
#include "rocking/scene/shaking.hpp"

/// The amplitude and the frequency of a base motion in the units of the file, and the other form beside them: g and Hz
/// beside A_h and Omega_h, these beside any physical unit.
namespace rocking {

/// The key of the other form.
[[nodiscard]] std::string_view other_form_of(std::string_view key);

[[nodiscard]] bool is_amplitude(std::string_view key);

/// The number with this key (see shaking_numbers).
[[nodiscard]] double number_of(const Shaking& shaking, std::string_view key);

/// A number with its unit or symbol: `A_h 4.5`, `1.1 g`, `Omega_h 10`, `3.01 Hz`.
[[nodiscard]] std::string in_unit(std::string_view key, const std::string& number);

/// `A_h 4.5 = 1.1 g`, `0.4 g = A_h 1.63`. `given_key`: Shaking::given_amplitude or given_frequency. The first number
/// has six digits, the second three.
[[nodiscard]] std::string in_both_forms(const Shaking& shaking, std::string_view given_key);

/// The shaking of the conditions of a table.
using Shakings = std::span<const std::optional<Shaking>>;

/// The forms in which the conditions are shown: the keys that some condition gives, and the other form of each.
[[nodiscard]] std::vector<std::string_view> shown_forms(Shakings shakings);

/// Keys of the columns that a table has beside its swept parameters: both forms of the amplitude and of the frequency
/// as far as they differ between the conditions, without those that are swept parameters.
[[nodiscard]] std::vector<std::string_view> shaking_columns(const std::vector<std::string>& swept, Shakings shakings);

/// What a table need not repeat in every row, `A_h 4.5 = 1.1 g, Omega_h 10 = 3.01 Hz`: the forms that are neither
/// columns nor swept. Of numbers that are drawn it says that they are means. Empty if there are none.
[[nodiscard]] std::string common_shaking(const std::vector<std::string>& swept, Shakings shakings);

/// The number of a column in four digits; a point without a shaking.
[[nodiscard]] std::string column_cell(const std::optional<Shaking>& shaking, std::string_view key);

/// How a shaking stands in documents: the keys that the experiment gives, and the numbers in every unit.
[[nodiscard]] const StructType& fields_of(const Shaking*);
[[nodiscard]] const StructType& fields_of(const VerticalShaking*);

struct Report;
/// The shaking of each condition.
[[nodiscard]] std::vector<std::optional<Shaking>> shakings_of(const Report& report);

/// What impacts leave of the tilt rate, in a sentence (RateRatios).
[[nodiscard]] std::string impacts_text(const Report& report);

}  // namespace rocking
