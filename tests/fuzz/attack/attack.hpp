#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "fuzz/attack/run_limited.hpp"
#include "rocking/text/json.hpp"
#include "support/split_mix.hpp"

namespace rocking::fuzz {

/// Starting point of all cases, made once: a finished run and its experiment.
struct Sound {
  std::filesystem::path program;
  std::filesystem::path folder;  ///< holds `quick.json`, `pulse.txt` and the run `out`
  std::string report;            ///< the part of the report of this run that must not change: see lasting_text
};

/// A report without the parts that may differ between equal runs; empty if it is not JSON.
[[nodiscard]] std::string lasting_text(const std::string& report);

/// Creates the contents of `sound.folder` with the program. Throws std::runtime_error if that fails.
[[nodiscard]] Sound make_sound(const std::filesystem::path& program, const std::filesystem::path& folder);

/// One case: its own folder and random numbers, and its findings. A generator fills it.
class Attack {
 public:
  Attack(const Sound& sound, std::filesystem::path folder, std::uint64_t seed)
      : random(seed), sound_(sound), folder_(std::move(folder)) {}

  support::SplitMix random;

  [[nodiscard]] const Sound& sound() const { return sound_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<std::string>& findings() const { return findings_; }

  /// A random element of the list.
  template <class List>
  [[nodiscard]] auto one_of(const List& list) {
    return *(std::begin(list) + random.below(static_cast<int>(std::size(list))));
  }

  void write(const std::filesystem::path& name, const std::string& bytes) const;
  [[nodiscard]] std::string read(const std::filesystem::path& name) const;
  [[nodiscard]] bool exists(const std::filesystem::path& name) const { return std::filesystem::exists(folder_ / name); }

  /// Copies the undamaged run to this name.
  void copy_sound_run(const std::string& name) const;

  /// Runs `rocking`. Any other exit code is a finding; so are a signal, a hang, control characters for the terminal,
  /// and messages too long to read.
  Ending run(const std::vector<std::string>& arguments, const std::set<int>& allowed);

  /// Checks a page that the program wrote, if there is one.
  void look_at_page(const std::filesystem::path& name);

  void find(const std::string& what) { findings_.push_back(what); }

 private:
  const Sound& sound_;
  std::filesystem::path folder_;
  std::vector<std::string> findings_;
};

/// The generators, one file each.
void attack_experiments(Attack& attack);
void attack_records(Attack& attack);
void attack_flags(Attack& attack);
void attack_reports(Attack& attack);
void attack_stores(Attack& attack);
void attack_texts(Attack& attack);

}  // namespace rocking::fuzz
