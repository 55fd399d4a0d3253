#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace rocking {

/// Value of `format` in a report.
inline constexpr std::string_view report_format = "rocking.report/1";

/// A JSON Schema (draft 07) that is written by hand, in reports/schemas.
struct Schema {
  std::string_view name;  ///< `experiment`, `report`, `trajectory`, `bifurcation`, `cost`, `fragility`, `motion`, ...
  std::string_view text;
};

[[nodiscard]] std::span<const Schema> schemas();
[[nodiscard]] std::optional<std::string_view> schema_text(std::string_view name);

}  // namespace rocking
