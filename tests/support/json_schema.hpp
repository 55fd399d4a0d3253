#pragma once

#include <string>
#include <string_view>

namespace rocking::support {

/// What one of our schemas says against a document: a line for each objection, empty where there is none.
[[nodiscard]] std::string objections(std::string_view schema_name, std::string_view text);

}  // namespace rocking::support
