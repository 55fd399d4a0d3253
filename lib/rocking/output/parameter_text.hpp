#pragma once

#include <span>
#include <string>
#include <vector>

#include "rocking/look/table.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/json.hpp"

/// Values of swept parameters in tables and sentences.
namespace rocking {

/// How a number of an experiment is called in tables and figures.
struct QuantityName {
  std::string quantity;  ///< `base amplitude`
  std::string symbol;    ///< `A_h`, where a `_` begins a subscript; may be empty
  std::string unit;      ///< empty: dimensionless
};

/// The name of the number at this place of an experiment.
[[nodiscard]] QuantityName quantity_name(const std::string& pointer);

/// The value of a swept parameter in a table: its name if it has one, `0.35/0.3` for friction, the value for anything else.
[[nodiscard]] std::string short_value(const Parameter& parameter);

/// The same in a sentence: its name if it has one, or `base amplitude 0.4 g`.
[[nodiscard]] std::string value_in_words(const Parameter& parameter);

/// An experiment with these values, as text.
[[nodiscard]] Json applied(Json experiment, const std::vector<Parameter>& parameters);

/// `0.5`, `0.5 to 2`; in `digits` digits.
[[nodiscard]] std::string range_in_words(const NumberRange& range, int digits);

/// A number in six digits, a law in three: `0.5`, `0.4 to 0.6 (drawn)`, `0.5 (drawn, standard deviation 0.05)`,
/// `0.4 to 0.6 (drawn, triangular)`.
[[nodiscard]] std::string quantity_in_words(const Quantity& quantity);

/// `friction 0.4/0.35, amplitude 6`; empty if nothing is swept.
[[nodiscard]] std::string values_of(const std::vector<Parameter>& parameters);

/// A table with a column for each parameter, named by its last key, and further columns.
[[nodiscard]] look::Table table_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& further);

/// A row that begins with their values.
[[nodiscard]] look::Row row_of(const std::vector<Parameter>& parameters, const look::Row& further = {});

/// Parts of file names that tell the parts of a sweep from each other, one for each list of parameters: the last key
/// and the value of each parameter, such as `static_0.35_amplitude_4.2`; where two parameters have the same last key,
/// the last two keys. They consist of letters, digits, `.`, `+`, `-` and `_`, have at most 120 bytes, and no two are
/// equal, also where upper and lower case count as equal; the later one of two gets a number. All lists have the same
/// pointers.
[[nodiscard]] std::vector<std::string> parameter_names(std::span<const std::vector<Parameter>> parts);

}  // namespace rocking
