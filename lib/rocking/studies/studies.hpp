#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/study/study.hpp"

/// The kinds of files that rocking reads and writes.
namespace rocking {

/// Those that rocking writes.
[[nodiscard]] std::vector<const Document*> documents();

/// The part of a format between `rocking.` and `/1`: `comparison`.
[[nodiscard]] std::string name_of(const Document& document);

/// Names of all formats, for `schema_of`.
[[nodiscard]] std::vector<std::string> format_names();

/// JSON Schema (draft 07) of a format, as in reports/schemas; absent if there is none of this name.
[[nodiscard]] std::optional<std::string> schema_of(std::string_view name);

/// Its keys as a table in Markdown, as in lib/docs/formats.md; absent likewise.
[[nodiscard]] std::optional<std::string> keys_of(std::string_view name);

}  // namespace rocking

/// The list of the studies. Who adds one adds a line to studies.cpp, and its folder to CMakeLists.txt.
namespace rocking {

/// All studies, in the order of `rocking --help`.
[[nodiscard]] std::span<const Study* const> studies();

/// The figures that studies add to those of a run with a suite of ground motions.
[[nodiscard]] std::vector<analysis::Figure> figures_of_studies(const RunShown& run);

}  // namespace rocking
