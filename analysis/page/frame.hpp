#pragma once

#include <string>

namespace rocking::analysis {

/// What surrounds the content of a page.
struct Frame {
  std::string title;
  bool has_charts = true;  ///< whether dygraphs is embedded, if it was available at the build
};

/// A page without external resources: `content` (HTML) below its title. Its content-security policy allows only its own
/// script and style, given by their hashes, and embedded pictures.
[[nodiscard]] std::string framed(const Frame& frame, const std::string& content);

}  // namespace rocking::analysis
