#include "program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
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

struct NamedCommand {
  std::string_view name;
  AddCommand add;
};

/// In the order of `rocking --help`, where the studies of the list stand between them.
constexpr std::array<NamedCommand, 5> before_studies{{{"run", add_run},
                                                      {"resume", add_resume},
                                                      {"status", alone<add_status>},
                                                      {"merge", alone<add_merge>},
                                                      {"verify", alone<add_verify>}}};
constexpr std::array<NamedCommand, 8> after_studies{{{"figure", alone<add_figure>},
                                                     {"report", alone<add_report>},
                                                     {"trajectory", alone<add_trajectory>},
                                                     {"replay", alone<add_replay>},
                                                     {"validate", alone<add_validate>},
                                                     {"schema", alone<add_schema>},
                                                     {"doctor", alone<add_doctor>},
                                                     {"completion", alone<add_completion>}}};

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
  const auto is_named = [word](const NamedCommand& command) { return command.name == word; };
  const auto is_study = [word](const Study* study) { return study->command() == word; };
  const bool one = word != "completion" &&
                   (std::ranges::any_of(before_studies, is_named) || std::ranges::any_of(studies(), is_study) ||
                    std::ranges::any_of(after_studies, is_named));
  const auto add_all = [&](std::span<const NamedCommand> commands) {
    for (const NamedCommand& command : commands) {
      if (!one || is_named(command)) command.add(app, action, pool);
    }
  };
  add_all(before_studies);
  for (const Study* study : studies()) {
    if (!one || is_study(study)) add_study(app, action, *study);
  }
  add_all(after_studies);
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

}  // namespace

ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool) {
  hold_standard_streams();
  meet_limits_as_errors();
  CLI::App app("Probabilities of the responses of a rocking block", "rocking");
  Action action;
  add_commands(app, action, pool, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(app.exit(error));  // --help, --version
    const auto explanation = explain_unknown_word(app, argc, argv);
    return fail(ExitCode::usage, fmt::format("{}\nTry `rocking --help`.", explanation.value_or(error.what())));
  }
  return carry_out(action);
}

}  // namespace rocking::program
