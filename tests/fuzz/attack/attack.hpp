#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "fuzz/attack/run_limited.hpp"
#include "rocking/report/json.hpp"
#include "support/split_mix.hpp"

namespace rocking::fuzz {

/// What all cases start from, made once: a finished run, and its experiment.
struct Sound {
  std::filesystem::path program;
  std::filesystem::path folder;  ///< holds `quick.json`, `pulse.txt` and the run `out`
  std::string report;            ///< what must not differ of that run's report: see lasting_text
};

/// A report without what may differ between equal runs; empty where it is no JSON.
[[nodiscard]] std::string lasting_text(const std::string& report);

/// Makes `sound.folder` with the program. Throws std::runtime_error where it does not work.
[[nodiscard]] Sound make_sound(const std::filesystem::path& program, const std::filesystem::path& folder);

/// One case: a folder of its own, random numbers of its own, and what was found. Whoever fills it is a generator.
class Attack {
 public:
  Attack(const Sound& sound, std::filesystem::path folder, std::uint64_t seed)
      : random(seed), sound_(sound), folder_(std::move(folder)) {}

  support::SplitMix random;

  [[nodiscard]] const Sound& sound() const { return sound_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<std::string>& findings() const { return findings_; }

  /// One of these, at random.
  template <class List>
  [[nodiscard]] auto one_of(const List& list) {
    return *(std::begin(list) + random.below(static_cast<int>(std::size(list))));
  }

  void write(const std::filesystem::path& name, const std::string& bytes) const;
  [[nodiscard]] std::string read(const std::filesystem::path& name) const;
  [[nodiscard]] bool exists(const std::filesystem::path& name) const { return std::filesystem::exists(folder_ / name); }

  /// A copy of the sound run with this name.
  void copy_sound_run(const std::string& name) const;

  /// Runs `rocking`. Anything but these exit codes is a finding; so are a signal, a hang, signs that a terminal obeys, and
  /// messages that no reader can survey.
  Ending run(const std::vector<std::string>& arguments, const std::set<int>& allowed);

  /// Looks at a page that the program wrote, if it is there.
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
