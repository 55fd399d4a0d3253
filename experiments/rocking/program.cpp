#include "program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "interrupt.hpp"
#include "output.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/studies/studies.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

// open returns the lowest free number; the lower ones are in use already.
void hold(int number, int mode) {
  if (::fcntl(number, F_GETFD) >= 0 || errno != EBADF) return;
  static_cast<void>(::open("/dev/null", mode));
}

/// Opens standard input, output and error if this process was started without them, so that no other file gets their
/// numbers. Writing to a closed standard output remains an error; text for a closed standard error is dropped.
void hold_standard_streams() {
  hold(STDIN_FILENO, O_RDONLY);
  hold(STDOUT_FILENO, O_RDONLY);  // a write fails with EBADF, as on a closed descriptor
  hold(STDERR_FILENO, O_WRONLY);
}

using AddCommand = void (*)(CLI::App&, Action&, const ProcessPool&);

template <void (*add)(CLI::App&, Action&)>
void alone(CLI::App& app, Action& action, const ProcessPool& /*pool*/) {
  add(app, action);
}

/// A command that is no study, by its name.
struct NamedCommand {
  std::string_view name;
  AddCommand add;
};

/// Commands under one heading of `rocking --help`.
struct CommandGroup {
  const char* heading;
  std::span<const NamedCommand> commands;
};

constexpr std::array<NamedCommand, 4> of_running{
    {{"run", add_run}, {"resume", add_resume}, {"verify", alone<add_verify>}, {"archive", alone<add_archive>}}};
constexpr std::array<NamedCommand, 2> of_looking{
    {{"report", alone<add_report>}, {"trajectory", alone<add_trajectory>}}};
constexpr std::array<NamedCommand, 4> of_tools{{{"validate", alone<add_validate>},
                                                {"schema", alone<add_schema>},
                                                {"doctor", alone<add_doctor>},
                                                {"completion", alone<add_completion>}}};
constexpr std::array<CommandGroup, 4> groups{
    {{"Run", of_running}, {"Look", of_looking}, {"Studies", {}}, {"Tools", of_tools}}};

/// Adds the command that `word` names, because describing all of them takes a sixth of the instructions of a short run;
/// otherwise all, also for `completion`, which lists them.
void add_commands(CLI::App& app, Action& action, const ProcessPool& pool, std::string_view word) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", std::string(base::build_info().version));
  app.require_subcommand(1);
  app.footer(
      "`rocking COMMAND --help` describes a command, with an example.\n"
      "Exit codes: 0 done, 1 a check failed, 64 usage, 65 bad input file, 66 missing input, 70 bug of rocking,\n"
      "74 input or output, 75 stopped early, 130 interrupted (`rocking resume` continues the run after both).\n");
  const auto add = [&](const char* heading, const auto& add_one) {
    add_one();
    app.get_subcommands([](const CLI::App*) { return true; }).back()->group(heading);
  };
  const auto add_all = [&](bool only_named) {
    for (const CommandGroup& group : groups) {
      for (const NamedCommand& command : group.commands) {
        if (!only_named || command.name == word) add(group.heading, [&] { command.add(app, action, pool); });
      }
      if (!group.commands.empty()) continue;
      for (const Study* study : studies()) {
        if (!only_named || study->command() == word) add(group.heading, [&] { add_study(app, action, *study); });
      }
    }
  };
  if (word != "completion") add_all(true);
  if (app.get_subcommands([](const CLI::App*) { return true; }).empty()) add_all(false);
}

/// Commands that have become part of others. Their words still work.
struct FormerCommand {
  std::string_view name;
  std::vector<std::string> now;
};

/// The words of the command line, without a former command; a note says what it is called now.
std::vector<std::string> with_present_names(std::vector<std::string> words) {
  static const std::array<FormerCommand, 4> former{
      {{"status", {"run", "--status"}}, {"merge", {"resume"}}, {"replay", {"trajectory"}}, {"figure", {"report"}}}};
  if (words.empty()) return words;
  const auto* const found = std::ranges::find(former, words.front(), &FormerCommand::name);
  if (found == former.end()) return words;
  print_notice(fmt::format("`rocking {}` is now `rocking {}`", found->name, fmt::join(found->now, " ")));
  const bool asks_for_help = words.size() > 1 && (words[1] == "-h" || words[1] == "--help");
  words.erase(words.begin());
  words.insert(words.begin(), found->now.begin(), asks_for_help ? found->now.begin() + 1 : found->now.end());
  return words;
}

ExitCode fail(ExitCode code, std::string_view message) {
  print_notice(message);
  return code;
}

// If all problems are those of flags, the file is not to blame.
ExitCode code_of(const base::InputError& error) {
  for (const base::Problem& problem : error.problems()) {
    if (!problem.place.starts_with("--")) return ExitCode::bad_input;
  }
  return ExitCode::usage;
}

ExitCode code_of(base::FolderError::Kind kind) {
  switch (kind) {
    case base::FolderError::Kind::missing: return ExitCode::missing_input;
    case base::FolderError::Kind::contradiction: return ExitCode::usage;
    case base::FolderError::Kind::different: return ExitCode::check_failed;
    case base::FolderError::Kind::in_the_way:
    case base::FolderError::Kind::at_work: break;
  }
  return ExitCode::input_output;
}

ExitCode carry_out(const Action& action) {
  try {
    return action();
  } catch (const base::Stopped&) {
    return fail(ExitCode::interrupted, "interrupted; nothing was written. The same command starts again");
  } catch (const base::InputError& error) {
    return fail(code_of(error), "the input cannot be used: " + listed_problems(error));
  } catch (const base::FolderError& error) {
    return fail(code_of(error.kind()), error.what());
  } catch (const UsageError& error) {
    return fail(ExitCode::usage, error.what());
  } catch (const MissingInput& error) {
    return fail(ExitCode::missing_input, error.what());
  } catch (const InTheWay& error) {
    return fail(ExitCode::input_output, error.what());
  } catch (const sqlite::UnusableFile& error) {
    return fail(ExitCode::bad_input, error.what());
  } catch (const std::system_error& error) {
    return fail(ExitCode::input_output, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::input_output, "not enough memory; use fewer realisations, conditions or sampled periods");
  } catch (const std::exception& error) {
    return fail(
        ExitCode::our_bug,
        fmt::format("a bug of this program; please report it with the output of `rocking doctor`: {}", error.what()));
  }
}

/// A flag that was taken for the value of the flag before it, `-o --json`; empty: none was.
std::string flag_taken_for_value(const CLI::App& app, const std::vector<std::string>& words) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      const bool may_be_flag = words[i].size() > 2 && words[i].starts_with("--");
      const CLI::Option* before = may_be_flag ? command->get_option_no_throw(words[i - 1]) : nullptr;
      if (before == nullptr || std::ranges::find(before->results(), words[i]) == before->results().end()) continue;
      return fmt::format("{0} {1}: needs a value before {1}; if that is the value, write --{2}={1}", words[i - 1],
                         words[i], before->get_lnames().empty() ? "flag" : before->get_lnames().front());
    }
  }
  return "";
}

}  // namespace

/// `--from: "x" is not a number` in place of `Could not convert: --from = x`.
static std::string words_of(const CLI::ParseError& error) {
  constexpr std::string_view beginning = "Could not convert: ";
  const std::string words = error.what();
  const std::size_t equals = words.find(" = ");
  if (!words.starts_with(beginning) || equals == std::string::npos) return words;
  return fmt::format("{}: \"{}\" is not a number", words.substr(beginning.size(), equals - beginning.size()),
                     words.substr(equals + 3));
}

ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool) {
  hold_standard_streams();
  meet_limits_as_errors();
  CLI::App app(
      "Probabilities of the responses of a rocking block\n\n"
      "  rocking run experiment.json -o out             simulate, and estimate the probability of each response\n"
      "  rocking fragility out --hazard hazard.csv      how often the block overturns in a year\n"
      "  rocking trajectory out --condition 3           one realisation of it in detail\n",
      "rocking");
  Action action;
  std::vector<std::string> words = with_present_names({argv + 1, argv + std::max(argc, 1)});
  add_commands(app, action, pool, words.empty() ? "" : words.front());
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(app.exit(error));  // --help, --version
    if (const auto gone = explain_gone_flag(words)) return fail(ExitCode::bad_input, *gone);
    const auto explanation = explain_unknown_word(app, words);
    return fail(ExitCode::usage,
                fmt::format("{}\nTry `{} --help`.", explanation.value_or(words_of(error)), called_command(app, words)));
  }
  if (const std::string fault = flag_taken_for_value(app, words); !fault.empty()) return fail(ExitCode::usage, fault);
  return carry_out(action);
}

}  // namespace rocking::program
