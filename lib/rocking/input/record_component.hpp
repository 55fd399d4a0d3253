#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The component that a line of a header names: `..., RIO DELL OVERPASS FF, 270 (CDMG STATION 89324)`, `COMP: UP`,
/// `Vertical component`. Empty if none of the known names stands there: it is the last field between commas, without what
/// stands in brackets behind it, or a word beside `component`.
[[nodiscard]] std::string component_in(std::string_view line);

/// The component that a line names beside the word `component`, or by the only SEED code of a sensor in it: `HNZ`, `BHN`.
[[nodiscard]] std::string component_word_in(std::string_view line);

/// Whether a header names a vertical component so: `UP`, `Up`, `HNZ`.
[[nodiscard]] bool is_vertical_component(std::string_view component);

/// Whether two names are of one component: in letters of any case, without `deg`, 0 and 360 being equal.
[[nodiscard]] bool is_same_component(std::string_view one, std::string_view other);

/// Why a ground motion is a vertical component: `by its name (UP)`, `by its header (UP)`; absent if nothing says so. Of a
/// name counts what stands behind its last separator, or behind the last digit of it, and the ending (`.UD`); `V` and `Z`
/// alone do not count against a header that names a horizontal component. A SEED code (`HNZ`) counts as a part of the name.
[[nodiscard]] std::optional<std::string> why_vertical(const GroundMotion& motion);

/// Why it is a horizontal one: `by its header (090)`, `by its name (EW)`.
[[nodiscard]] std::optional<std::string> why_horizontal(const GroundMotion& motion);

/// Whether a record is of a sensor in a borehole: by its header, or by its name as KiK-net has it (`.NS1`, `.EW1`).
[[nodiscard]] bool is_of_borehole(const GroundMotion& motion);

}  // namespace rocking
