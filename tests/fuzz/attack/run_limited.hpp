#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rocking::fuzz {

/// Limits of a process. Beyond a limit the kernel ends the process or refuses its request.
struct Limits {
  unsigned processor_seconds = 30;
  unsigned wall_seconds = 120;
  std::size_t memory_bytes = std::size_t{4} << 30U;
  std::size_t file_bytes = std::size_t{64} << 20U;
};

/// How a process ended.
struct Ending {
  std::optional<int> exit_code;  ///< absent if a signal ended it
  int signal = 0;
  bool out_of_time = false;  ///< killed by us after `wall_seconds`, or by the kernel after `processor_seconds`
  std::string output;        ///< standard output
  std::string errors;        ///< standard error
};

/// Runs a program in `folder` with these arguments, an empty standard input and a minimal environment.
[[nodiscard]] Ending run_limited(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                 const std::filesystem::path& folder, const Limits& limits);

}  // namespace rocking::fuzz
