#pragma once

#include <string_view>

#include "rocking/input/object_reader.hpp"

namespace rocking {

/// Checks a document that a file holds against one of our schemas (`schema_text(schema)`), and that no number in it
/// lies beyond 1e18 in magnitude. Appends at most twenty problems; the place of each is a JSON pointer that begins with
/// `place`, where the document stands in its file.
void check_document(const Json& document, std::string_view schema, const std::string& place, Problems& problems);

}  // namespace rocking
