#include "machine.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace rocking::program {
namespace {

std::string processor_name() {
  std::ifstream facts("/proc/cpuinfo");
  for (std::string line; std::getline(facts, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

/// The number in the first line of a file; absent for other text, such as `max` (no limit).
std::optional<std::uint64_t> number_in(const std::filesystem::path& path) {
  std::uint64_t number = 0;
  if (std::ifstream file(path); file >> number) return number;
  return std::nullopt;
}

/// Memory that the kernel can provide without swapping.
std::optional<std::uint64_t> free_on_machine() {
  std::ifstream facts("/proc/meminfo");
  std::string name;
  std::uint64_t kilobytes = 0;
  for (std::string unit; facts >> name >> kilobytes && std::getline(facts, unit);) {
    if (name == "MemAvailable:") return 1024 * kilobytes;
  }
  return std::nullopt;
}

/// Free memory within the control group (version 2) of this process and its parents, as a scheduler or container limits
/// it.
std::optional<std::uint64_t> free_in_control_group() {
  std::ifstream file("/proc/self/cgroup");
  std::string line;
  while (std::getline(file, line) && !line.starts_with("0::/")) {
  }
  if (!line.starts_with("0::/")) return std::nullopt;
  const std::filesystem::path root("/sys/fs/cgroup");
  std::optional<std::uint64_t> least;
  for (std::filesystem::path group = root / line.substr(4);; group = group.parent_path()) {
    const auto most = number_in(group / "memory.max");
    const auto used = number_in(group / "memory.current");
    if (most && used) least = std::min(least.value_or(*most), *most - std::min(*most, *used));
    if (group == root || !group.has_relative_path()) return least;
  }
}

std::optional<std::uint64_t> free_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const std::uint64_t used =
      number_in("/proc/self/statm").value_or(0) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

}  // namespace

std::string machine_description() {
  utsname system{};
  const bool known = uname(&system) == 0;
  const std::string name =
      known ? fmt::format("{} {} {}", system.sysname, system.release, system.machine) : "unknown system";
  return fmt::format("{}, {} threads, {}", processor_name(), available_threads(), name);
}

std::string system_name() {
  std::ifstream facts("/etc/os-release");
  const std::string key = "PRETTY_NAME=";
  for (std::string line; std::getline(facts, line);) {
    if (!line.starts_with(key)) continue;
    line.erase(0, key.size());
    std::erase(line, '"');
    return line;
  }
  return "unknown system";
}

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

std::function<double()> seconds_from_now() {
  return [start = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
}

double thread_seconds() {
  timespec used{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used) != 0) {
    throw std::system_error(errno, std::generic_category(), "the processor time of a thread cannot be read");
  }
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

std::optional<std::uint64_t> available_memory() {
  std::optional<std::uint64_t> least;
  for (const auto& free : {free_on_machine(), free_in_control_group(), free_address_space()}) {
    if (free) least = std::min(least.value_or(*free), *free);
  }
  return least;
}

unsigned available_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace rocking::program
