#pragma once

#include <string>

namespace rocking {

/// JSON Schema (draft 07) of experiment files, as reports/schemas has it.
[[nodiscard]] std::string experiment_schema_text();

/// The keys of experiment files as a table in Markdown, as lib/docs/formats.md has it.
[[nodiscard]] std::string experiment_table();

}  // namespace rocking
