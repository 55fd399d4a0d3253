#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rocking::base {

/// How this library was built: version, source, compiler and flags. Set at build time; the same in every run of one
/// build.
struct BuildInfo {
  std::string version;     ///< of the project, as in CHANGELOG.md
  std::string revision;    ///< of the source, as version control describes it; "unknown" outside a checkout
  std::string compiler;    ///< name and version
  std::string flags;       ///< compiler flags that affect numerical results
  std::string build_type;  ///< Release, RelWithDebInfo, ...
  std::optional<std::string> libraries;  ///< of others, with their versions; earlier reports do not state them
};

[[nodiscard]] BuildInfo build_info();

/// Version and revision in one text, as a store records them.
[[nodiscard]] std::string code_identity();

/// A property of this machine's arithmetic on which the bits of results depend.
struct ArithmeticCheck {
  std::string_view name;  ///< as `rocking doctor --json` names it
  bool passed = false;
};

/// Examines the arithmetic of this machine and of this build. If all checks pass, results have the same bits as on other
/// machines.
[[nodiscard]] std::vector<ArithmeticCheck> arithmetic_checks();

}  // namespace rocking::base
