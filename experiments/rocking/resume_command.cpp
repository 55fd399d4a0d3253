#include <memory>
#include <string>

#include "campaign.hpp"
#include "program.hpp"

namespace rocking::program {
namespace {

struct ResumeRequest {
  std::string folder;
  Overrides extension;
  ExecutionOptions execution;
};

ExitCode resume(const ResumeRequest& request) {
  return run_to_end(resume_run(request.folder, request.extension, means_of(request.execution)), request.execution);
}

}  // namespace

void add_resume(CLI::App& app, Action& action, const ProcessPool& pool) {
  const auto request = std::make_shared<ResumeRequest>();
  request->execution = {.threads = pool.threads, .max_time = {}, .loudness = {}, .pool = pool};
  CLI::App* command = app.add_subcommand("resume", "Finish a run that was stopped, or extend one");
  command->footer(
      "Example: rocking resume out\n"
      "runs the realisations that are missing in out/realisations.sqlite and writes the report. All of it but `system` "
      "has the same bytes as without the interruption. If the file is damaged, the intact rows are kept, and the "
      "damaged file is kept under another name. With --realisations N or --levels it extends the run: the bytes are "
      "those of one run of N, or with these levels.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command
      ->add_option("--realisations", request->extension.realisations,
                   "Extend the run, finished or not, to N realisations per condition")
      ->type_name("N");
  command
      ->add_option("--levels", request->extension.levels,
                   "Extend the run by intensities, as `rocking fragility --suggest` names them: 0.23,0.9")
      ->type_name("X,X")
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_threads(*command, request->execution);
  add_max_time(*command, request->execution);
  add_page_choice(*command, request->execution.page);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return resume(*request); }; });
}

}  // namespace rocking::program
