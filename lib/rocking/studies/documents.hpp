#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/document.hpp"

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
