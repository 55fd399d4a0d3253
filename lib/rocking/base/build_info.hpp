#pragma once

#include <string>

namespace rocking::base {

/// How this library was built: version, source, compiler and flags. Set at build time; the same in every run of one
/// build.
struct BuildInfo {
  std::string version;     ///< of the project, as in CHANGELOG.md
  std::string revision;    ///< of the source, as version control describes it; "unknown" outside a checkout
  std::string compiler;    ///< name and version
  std::string flags;       ///< compiler flags that affect numerical results
  std::string build_type;  ///< Release, RelWithDebInfo, ...
};

[[nodiscard]] BuildInfo build_info();

/// Version and revision in one text, as a store records them.
[[nodiscard]] std::string code_identity();

}  // namespace rocking::base
