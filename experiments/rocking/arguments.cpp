#include "arguments.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/studies.hpp"

namespace rocking::program {
namespace {

/// The value if the entire text is one; absent otherwise.
template <class Number>
std::optional<Number> read_whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::optional<double> seconds_of_unit(const std::string& unit) {
  constexpr std::array<std::pair<std::string_view, double>, 5> units{
      {{"", 1.0}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}}};
  for (const auto& [name, seconds] : units) {
    if (name == unit) return seconds;
  }
  return std::nullopt;
}

/// The seconds of a time such as 90s, 15min, 2h, 1d; a number without a unit is in seconds. Absent if it is none.
std::optional<double> seconds_in(std::string_view text) {
  const std::string_view all = trimmed(text);
  const std::size_t digits = std::min(all.find_first_not_of("0123456789."), all.size());
  const auto number = read_whole<double>(all.substr(0, digits));
  const auto unit = seconds_of_unit(CLI::detail::to_lower(std::string(trimmed(all.substr(digits)))));
  if (!number || !unit) return std::nullopt;
  const double seconds = *number * *unit;
  return seconds > 0.0 && std::isfinite(seconds) ? std::optional<double>(seconds) : std::nullopt;
}

/// `2/5` as a shard.
Shard shard_from(const std::string& text) {
  constexpr std::uint64_t most_parts = 999'999'999;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto part = read_whole<std::uint64_t>(std::string_view(text).substr(0, slash));
    const auto parts = read_whole<std::uint64_t>(std::string_view(text).substr(slash + 1));
    if (part && parts && 1 <= *part && *part <= *parts && *parts <= most_parts) return {.part = *part, .parts = *parts};
  }
  throw CLI::ValidationError(
      "--shard", fmt::format("{} is not a part of a whole; give i/n with 1 <= i <= n, for example 2/5", text));
}

/// Name of the argument that means standard input.
constexpr std::string_view standard_input = "-";

// To its end, but not much more than an experiment may have.
std::string text_on_standard_input() {
  std::string text;
  char buffer[65536];
  while (text.size() <= most_experiment_bytes) {
    const std::size_t count = std::fread(buffer, 1, sizeof buffer, stdin);
    text.append(buffer, count);
    if (count == sizeof buffer) continue;
    if (std::ferror(stdin) != 0) {
      throw std::system_error(errno, std::generic_category(), "standard input: cannot be read");
    }
    break;
  }
  return text;
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](const std::string& written) -> std::string {
    const auto value = read_whole<std::uint64_t>(written);
    if (value && low <= *value && *value <= high) return "";
    return fmt::format("\"{}\" is not a whole number from {} to {}; give a value such as {}", written, low, high, low);
  };
  return {check, "", "whole number"};
}

CLI::Validator number(double low, double high) {
  const auto check = [low, high](const std::string& written) -> std::string {
    const auto value = read_whole<double>(written);
    if (value && low <= *value && *value <= high) return "";
    return fmt::format("\"{}\" is not a number from {:g} to {:g}", written, low, high);
  };
  return {check, "", "number"};
}

CLI::Validator duration() {
  const auto transform = [](std::string& written) -> std::string {
    const auto seconds = seconds_in(written);
    if (!seconds) {
      return fmt::format("\"{}\" is not a positive duration; give one such as 90s, 15min, 2h or 1d", written);
    }
    written = fmt::format("{}", *seconds);
    return "";
  };
  CLI::Validator validator;
  validator.name("duration").operation(transform);
  return validator;
}

void add_shard(CLI::App& command, std::optional<Shard>& shard) {
  const auto set = [&shard](const std::string& text) { shard = shard_from(text); };
  command
      .add_option_function<std::string>("--shard", set,
                                        "Run only the i-th of n parts; `rocking resume WHOLE PART PART` joins them")
      ->type_name("I/N");
}

void add_threads(CLI::App& command, ExecutionOptions& execution) {
  command
      .add_option("-j,--threads", execution.threads,
                  "Number of threads; default: all that this process may use; changes the time, never the result")
      ->check(whole_number(1, 4096))
      ->type_name("N");
}

void add_max_time(CLI::App& command, ExecutionOptions& execution) {
  command
      .add_option("--max-time", execution.max_time,
                  "Stop cleanly after this time, e.g. 90 (seconds), 15min, 2h, 1d, with exit code 75; can be resumed")
      ->transform(duration())
      ->type_name("T");
}

void add_page_choice(CLI::App& command, PageChoice& page) {
  command.add_flag_callback(
      "--no-page", [&page] { page = PageChoice::omitted; },
      "Draw no page, and remove an earlier one; `rocking report DIR` draws it later");
}

std::string folder_of_run(const std::string& written) {
  const std::filesystem::path path(written);
  const std::string name = path.filename().string();
  const bool is_of_run = name == "report.json" || name == "report.html" || name == "realisations.sqlite" ||
                         std::ranges::any_of(studies(), [&name](const Study* study) { return study->file == name; });
  std::error_code ignored;
  if (!is_of_run || !std::filesystem::is_regular_file(path, ignored)) return written;
  return path.has_parent_path() ? path.parent_path().string() : ".";
}

CLI::Validator run_folder() {
  const auto transform = [](std::string& written) -> std::string {
    written = folder_of_run(written);
    return "";
  };
  CLI::Validator validator;
  validator.name("").operation(transform);
  return validator;
}

CLI::Option* add_experiment(CLI::App& command, std::string& file) {
  return command.add_option("EXPERIMENT", file, "Experiment file (JSON); -: standard input")->required();
}

void add_skip_unreadable(CLI::App& command, Overrides& overrides) {
  command.add_flag("--skip-unreadable", overrides.skips_unreadable,
                   "Leave out records of a suite that cannot be read; the report names them");
}

CLI::Option* add_realisations(CLI::App& command, Overrides& overrides, const std::string& description) {
  return command.add_option("--realisations", overrides.realisations, description)->type_name("N");
}

void add_seed(CLI::App& command, Overrides& overrides) {
  command.add_option("--seed", overrides.seed, "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
}

ExperimentText load_experiment_text(const std::string& path) {
  return input_of([&]() -> ExperimentText {
    if (path == standard_input) return {.text = text_on_standard_input(), .name = "standard input", .folder = "."};
    return experiment_text_of(path);
  });
}

Experiment load_experiment(const ExperimentText& source, const Overrides& overrides) {
  return input_of([&] { return experiment_in(source, overrides); });
}

Experiment load_experiment(const std::string& path, const Overrides& overrides) {
  return load_experiment(load_experiment_text(path), overrides);
}

Experiment load_sampled_experiment(const std::string& path, const Overrides& overrides) {
  const ExperimentText source = load_experiment_text(path);
  Experiment experiment = load_experiment(source, overrides);
  check_source(source, [&experiment] { check_strobe(experiment); });
  return experiment;
}

}  // namespace rocking::program
