#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign.hpp"
#include "machine.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::program {

inline constexpr std::uint64_t largest_sample = random::realisation_limit;

struct VerifyRequest {
  std::string folder;
  std::string name;  ///< of what is verified, for readers: the folder, or the archive that was unpacked there
  std::optional<std::uint64_t> sample;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// What was checked of a folder.
struct FolderCheck {
  std::vector<Fact> facts;  ///< how much was made again
  std::string table;        ///< of what is right
  std::vector<std::string> findings;

  void add(const RunCheck& check, std::string_view key, const std::string& right) {
    facts.push_back({std::string(key), check.checked});
    table += right;
    findings.insert(findings.end(), check.findings.begin(), check.findings.end());
  }
};

/// Verifies the run in a folder, and the studies there, with progress. Throws UsageError and MissingInput if there is nothing
/// to verify.
[[nodiscard]] FolderCheck check_of(const VerifyRequest& request);

}  // namespace rocking::program
