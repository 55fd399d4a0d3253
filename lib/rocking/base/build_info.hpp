#pragma once

#include <string_view>

namespace rocking::base {

/// What this library was built from, and how. Fixed at build time; differs between builds, never between runs.
struct BuildInfo {
  std::string_view version;     ///< of the project, as in CHANGELOG.md
  std::string_view revision;    ///< of the source, as version control describes it; "unknown" outside a checkout
  std::string_view compiler;    ///< name and version
  std::string_view flags;       ///< those that matter to the numbers
  std::string_view build_type;  ///< Release, RelWithDebInfo, ...
};

[[nodiscard]] BuildInfo build_info();

}  // namespace rocking::base
