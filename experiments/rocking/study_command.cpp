#include <memory>
#include <string>

#include <fmt/format.h>

#include "arguments.hpp"
#include "program.hpp"
#include "study_call.hpp"
#include "study_flags.hpp"

namespace rocking::program {
namespace {

void add_subject(CLI::App& command, StudyCommand& asked) {
  const SubjectKind subject = asked.study.subject;
  if (subject == SubjectKind::experiment) add_experiment(command, asked.experiment);
  if (subject == SubjectKind::runs) {
    command.add_option("DIR", asked.folders, "Folders of finished runs")->required()->transform(run_folder());
  }
  if (subject != SubjectKind::two_runs) return;
  const auto add = [&command, &asked](const char* name, const char* description) {
    const auto append = [&asked](const std::string& folder) { asked.folders.push_back(folder_of_run(folder)); };
    command.add_option_function<std::string>(name, append, description)->required();
  };
  add("DIR_A", "Folder of a run");
  add("DIR_B", "Folder of another run");
}

}  // namespace

void add_study(CLI::App& app, Action& action, const Study& study) {
  const auto request = std::make_shared<StudyCommand>(study);
  CLI::App* command = app.add_subcommand(study.command(), std::string(study.sentence));
  command->footer(fmt::format("Example: rocking {} {}\n{}", study.command(), study.example, study.text));
  add_subject(*command, *request);
  add_flags(*command, *study.question, request->question.get());
  if (!study.file.empty()) request->file.add_to(*command, study.needs_folder);
  if (!study.kept.empty()) request->file.add_resume(*command, study.kept);
  if (study.draws) {
    command->add_option("--figure", request->figures, "Folder for figures; created if necessary")->type_name("DIR");
    add_style(*command, request->style);
  }
  if (!study.progress.empty() && study.subject == SubjectKind::experiment) add_threads(*command, request->execution);
  if (study.takes_seed) add_seed(*command, request->overrides);
  if (!study.realisations.empty()) {
    add_realisations(*command, request->overrides, std::string(study.realisations));
  }
  if (study.has_long_table) add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return carry_out(*request); }; });
}

}  // namespace rocking::program
