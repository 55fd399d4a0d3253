#include "study_call.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "rocking/text/files.hpp"
#include "study_flags.hpp"

namespace rocking::program {
namespace {

NamedRun run_in(const std::string& folder, bool is_complete, unsigned threads) {
  RunFolder(folder).expect_installed();
  StoredRun stored = input_of([&] { return open_run(folder, threads); });
  if (is_complete && (stored.run.done < stored.run.all || !stored.run.is_complete())) {
    throw MissingInput(fmt::format(
        "{}: has {} of {} realisations; `rocking resume {}`, or `rocking resume WHOLE` with all parts, completes it",
        folder, stored.run.done, stored.run.all, shell_word(folder)));
  }
  return {folder, std::move(stored)};
}

/// What `ask` gives; problems of the question name its flags.
template <class Ask>
auto in_flags(const Study& study, const Ask& ask) {
  try {
    return ask();
  } catch (const UnfitQuestion&) {
    throw;  // see carry_out
  } catch (const base::InputError& error) {
    throw with_flags(error, *study.question);
  }
}

/// The subject, with a checked question. Throws before any file is written.
Subject checked_subject(const StudyCommand& command) {
  const Study& study = command.study;
  Subject subject;
  const auto check = [&] { input_of([&] { study.check(subject, command.question.get()); }); };
  for (const std::string& folder : command.folders) {
    subject.runs.push_back(run_in(folder, study.subject == SubjectKind::runs, command.execution.threads));
  }
  if (study.subject != SubjectKind::experiment) {
    check();
    return subject;
  }
  const ExperimentText source = load_experiment_text(command.experiment);
  subject.experiment = load_experiment(source, command.overrides);
  subject.folder = source.folder;
  check_source(source, check);
  return subject;
}

void expect_free(const StudyCommand& command, const Subject& subject) {
  for (const std::filesystem::path& file : new_files(*command.study.question, command.question.get())) {
    command.file.expect_free(file);
  }
  if (command.study.files == nullptr) return;
  for (const std::string& name : command.study.files(subject)) {
    command.file.expect_free(command.file.folder() / name);
  }
}

/// The lines that name the files beside the document; where they are many, the first.
std::string lines_on(const std::vector<TextFile>& files, const StudyCommand& command) {
  constexpr std::size_t most_named = 4;
  const bool names_all = command.execution.extent == Extent::all || files.size() <= most_named;
  std::string lines;
  for (std::size_t i = 0; i < (names_all ? files.size() : 1); ++i) {
    lines += fmt::format("        {}\n", (command.file.folder() / files[i].name).string());
  }
  if (names_all) return lines;
  return lines + fmt::format("        and one file for each diagram, {} in all\n", files.size() - 1);
}

/// What became of the pictures and pages beside an answer.
struct Extras {
  analysis::WrittenFigures figures;
  More more;
};

/// Writes the document, the files beside it, figures and more; the lines that say so.
std::string write(const StudyCommand& command, const Subject& subject, const Answer& answer,
                  const analysis::FigureLook& look, Extras& extras) {
  expect_free(command, subject);
  for (const TextFile& file : answer.files) write_atomically(command.file.folder() / file.name, file.text);
  std::string where = command.file.write(answer.document) + lines_on(answer.files, command);
  if (!command.figures.empty()) {
    extras.figures =
        analysis::write_figures(answer.figures, command.figures, command.style.pictures, stop_on_signal(), look);
    where += fmt::format("{}\n", fmt::join(extras.figures.files, "\n"));
  }
  if (answer.write_more) extras.more = answer.write_more({.stop = &stop_on_interrupt()});
  return answer.is_alone ? "" : where + extras.more.lines;
}

Answer answer_of(StudyCommand& command, const Subject& subject) {
  const Study& study = command.study;
  const SystemFacts system = system_facts(command.execution.threads);
  const std::string_view then = study.then == nullptr ? "" : study.then(command.question.get());
  if (!then.empty() && !command.execution.loudness.quiet) print_notice(study.more_notice);
  Progress progress(study.progress.empty() ? ProgressStyle::none : suitable_progress_style(command.execution.loudness),
                    std::string(study.progress), std::string(then));
  Circumstances circumstances{
      .execution = watched(command.execution, progress),
      .provenance = {.machine = system.machine, .start = system.start, .threads = system.threads},
      .extent = command.execution.extent,
      .draws = !command.figures.empty()};
  circumstances.execution.elapsed_seconds = seconds_from_now();
  circumstances.execution.processor_seconds = thread_seconds;
  if (!study.kept.empty()) {
    circumstances.keep = [&](const std::function<std::string()>& document) { command.file.keep(document); };
  }
  const auto find = [&] { return study.find(subject, command.question.get(), circumstances); };
  if (study.subject == SubjectKind::none) return in_flags(study, [&find] { return input_of(find); });
  // An experiment is read before; the other studies read what the question names.
  return study.subject == SubjectKind::experiment ? find() : input_of(find);
}

ExitCode end_of(const StudyCommand& command, const Answer& answer, const Extras& extras) {
  for (const std::string& notice : answer.notices) print_notice(notice);
  for (const std::string& notice : extras.more.notices) print_notice(notice);
  if (answer.end == AnswerEnd::refuted) return ExitCode::check_failed;
  if (answer.end == AnswerEnd::stopped) {
    print_notice(fmt::format("interrupted; the finished {} are in {}. The same command with --resume goes on",
                             command.study.kept, command.file.path().string()));
    return ExitCode::interrupted;
  }
  const ExitCode drawn = tell(extras.figures.failures, no_figure, PictureRole::purpose);
  return extras.more.is_complete ? drawn : ExitCode::input_output;
}

ExitCode answered(StudyCommand& command) {
  const Study& study = command.study;
  const analysis::FigureLook look = look_for(command.style);
  const Subject subject = in_flags(study, [&] { return checked_subject(command); });
  expect_free(command, subject);
  command.file.prepare();
  if (command.file.resumes() && std::filesystem::exists(command.file.path())) {
    command.file.read_earlier([&](const Json& earlier) { study.resume(subject, command.question.get(), earlier); });
  }
  const Answer answer = answer_of(command, subject);
  if (!command.execution.loudness.quiet) {
    for (const std::string& warning : answer.warnings) print_notice(warning);
  }
  Extras extras;
  deliver_study(command.execution.loudness, answer.document, heading(subject.experiment) + answer.table,
                [&] { return write(command, subject, answer, look, extras); });
  return end_of(command, answer, extras);
}

}  // namespace

ExitCode carry_out(StudyCommand& command) {
  try {
    return answered(command);
  } catch (const UnfitQuestion& error) {
    throw UsageError(with_flags(error, *command.study.question).what());
  }
}

}  // namespace rocking::program
