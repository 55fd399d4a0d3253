#pragma once

#include <string>
#include <string_view>

namespace rocking::support {

/// Violations of one of the project's schemas by a document: one line each, empty if there is none.
[[nodiscard]] std::string objections(std::string_view schema_name, std::string_view text);

}  // namespace rocking::support
