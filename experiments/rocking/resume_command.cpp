#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "output.hpp"
#include "program.hpp"

namespace rocking::program {
namespace {

struct ResumeRequest {
  std::string folder;
  std::vector<std::string> shards;
  bool overwrite = false;
  Overrides extension;
  ExecutionOptions execution;
};

ExitCode resume(const ResumeRequest& request) {
  if (!request.shards.empty()) {
    const std::vector<std::filesystem::path> parts(request.shards.begin(), request.shards.end());
    return write_merged(merge_runs(request.folder, parts, request.overwrite, print_notice), request.execution);
  }
  return run_to_end(resume_run(request.folder, request.extension, means_of(request.execution)), request.execution);
}

}  // namespace

void add_resume(CLI::App& app, Action& action, const ProcessPool& pool) {
  const auto request = std::make_shared<ResumeRequest>();
  request->execution = {.threads = pool.threads, .max_time = {}, .loudness = {}, .pool = pool};
  CLI::App* command = app.add_subcommand("resume", "Finish a run that was stopped, extend one, or join its shards");
  command->footer(
      "Example: rocking resume out\n"
      "runs the realisations that are missing in out/realisations.sqlite and writes the report. All of it but `system` "
      "has the same bytes as without the interruption. If the file is damaged, the intact rows are kept, and the "
      "damaged file is kept under another name. With --realisations N or --levels it extends the run: the bytes are "
      "those of one run of N, or with these levels.\n"
      "`rocking resume out shard1 shard2 shard3` copies the realisations of the three folders to out and writes the "
      "report, with the bytes of one run, except `system`. The order of the folders has no influence; shards may "
      "overlap if their common realisations agree.");
  command->add_option("DIR", request->folder, "Folder of the run, or for the whole of the shards")
      ->required()
      ->transform(run_folder());
  CLI::Option* shards =
      command->add_option("SHARD", request->shards, "Folders of the parts of a run (--shard), to be joined");
  command
      ->add_flag("--overwrite", request->overwrite,
                 "With SHARDs: replace the run in the folder, after all shards are read and found to agree")
      ->needs(shards);
  CLI::Option* realisations = add_realisations(*command, request->extension,
                                               "Extend the run, finished or not, to N realisations per condition");
  CLI::Option* levels =
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
  shards->excludes(realisations)->excludes(levels);
  for (const char* flag : {"--threads", "--max-time"}) shards->excludes(command->get_option(flag));
  add_page_choice(*command, request->execution.page);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return resume(*request); }; });
}

}  // namespace rocking::program
