#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "output.hpp"
#include "program.hpp"
#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/store/realisation_key.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::program {

/// Accepts whole numbers from `low` to `high`, written as digits.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

/// Accepts numbers from `low` to `high`.
[[nodiscard]] CLI::Validator number(double low, double high);

/// Accepts positive times such as 90s, 15min, 2h, 1d, and converts them to seconds.
[[nodiscard]] CLI::Validator duration();

/// Adds `--shard i/n`.
void add_shard(CLI::App& command, std::optional<Shard>& shard);

/// Whether a run ends with a page, report.html.
enum class PageChoice : std::uint8_t { drawn, omitted };

/// Options that `run`, `resume` and `verify` have in common.
struct ExecutionOptions {
  unsigned threads = 1;
  std::optional<double> max_time;  ///< stop cleanly after this long [s]
  Loudness loudness;
  ProcessPool pool = {};
  PageChoice page = PageChoice::drawn;
  Extent extent = Extent::one_screen;
};

/// Adds `-j`, and `--max-time` for commands whose run can be resumed.
void add_threads(CLI::App& command, ExecutionOptions& execution);
void add_max_time(CLI::App& command, ExecutionOptions& execution);
/// Adds `--no-page`.
void add_page_choice(CLI::App& command, PageChoice& page);

/// The folder of a run: of a file in it, as out/report.json, that folder; otherwise what is written.
[[nodiscard]] std::string folder_of_run(const std::string& written);
/// Takes folder_of_run.
[[nodiscard]] CLI::Validator run_folder();

/// Adds the argument EXPERIMENT.
CLI::Option* add_experiment(CLI::App& command, std::string& file);
/// Adds `--skip-unreadable`.
void add_skip_unreadable(CLI::App& command, Overrides& overrides);
/// Adds `--realisations`.
CLI::Option* add_realisations(CLI::App& command, Overrides& overrides, const std::string& description);
/// Adds `--seed`.
void add_seed(CLI::App& command, Overrides& overrides);

/// Reads a file or, if the path is `-`, standard input to its end; file names in the latter are relative to the current
/// folder. Throws MissingInput where it cannot be read.
[[nodiscard]] ExperimentText load_experiment_text(const std::string& path);

/// Reads the experiment in it. Throws base::InputError, or MissingInput where it, or a file that it names, cannot be
/// read.
[[nodiscard]] Experiment load_experiment(const ExperimentText& source, const Overrides& overrides = {});
[[nodiscard]] Experiment load_experiment(const std::string& path, const Overrides& overrides = {});

/// The same of an experiment whose responses strobe points are to tell (check_strobe).
[[nodiscard]] Experiment load_sampled_experiment(const std::string& path, const Overrides& overrides);

/// Carries out a check of the experiment; its problems get the file and the line.
template <class Check>
void check_source(const ExperimentText& source, Check check) {
  try {
    check();
  } catch (const base::InputError& error) {
    throw located(error, source.text, source.name);
  }
}

}  // namespace rocking::program
