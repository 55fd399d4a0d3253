#pragma once

#include <optional>
#include <string_view>

#include "rocking/base/error.hpp"

/// Files that are not read, named as what they look like, with the way to go.
namespace rocking {

/// A file that is no text in UTF-8: a spreadsheet, an archive, a binary format of seismograms or of a program. Absent: it may
/// be one.
[[nodiscard]] std::optional<Refusal> refuse_binary_file(std::string_view bytes);

/// A text in a format of ground motions that is not read. Absent: none is recognised.
[[nodiscard]] std::optional<Refusal> refuse_text_format(std::string_view text);

}  // namespace rocking
