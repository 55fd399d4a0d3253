#include "machine.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string_view>
#include <system_error>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

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

double thread_seconds() {
  timespec used{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used) != 0) {
    throw std::system_error(errno, std::generic_category(), "the processor time of a thread cannot be read");
  }
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

unsigned available_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace rocking::program
