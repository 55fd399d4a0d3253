#pragma once

#include <string_view>

namespace rocking::base {

/// How this library was built: version, source, compiler and flags. Set at build time; the same in every run of one
/// build.
struct BuildInfo {
  std::string_view version;     ///< of the project, as in CHANGELOG.md
  std::string_view revision;    ///< of the source, as version control describes it; "unknown" outside a checkout
  std::string_view compiler;    ///< name and version
  std::string_view flags;       ///< compiler flags that affect numerical results
  std::string_view build_type;  ///< Release, RelWithDebInfo, ...
};

[[nodiscard]] BuildInfo build_info();

}  // namespace rocking::base
