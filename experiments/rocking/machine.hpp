#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace rocking::program {

/// Names of the processor and the operating system, and the number of threads.
[[nodiscard]] std::string machine_description();

/// The operating system's name and version from /etc/os-release: `Debian GNU/Linux 13 (trixie)`.
[[nodiscard]] std::string system_name();

/// The time now, ISO 8601 in UTC: `2012-02-01T12:00:00Z`.
[[nodiscard]] std::string utc_now();

/// A clock that begins now [s].
[[nodiscard]] std::function<double()> seconds_from_now();

/// Processor time that the calling thread has used [s].
[[nodiscard]] double thread_seconds();

/// Bytes of memory that this process can still use, by the machine, its control group and its limit of address space;
/// absent if none of them is known.
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// How many threads this process may run at once; at least 1.
[[nodiscard]] unsigned available_threads();

}  // namespace rocking::program
