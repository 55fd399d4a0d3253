#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "program.hpp"

namespace rocking::program {
namespace {

struct MergeRequest {
  std::string folder;
  std::vector<std::string> shards;
  bool overwrite = false;
  ExecutionOptions execution;
};

ExitCode merge(const MergeRequest& request) {
  const std::vector<std::filesystem::path> parts(request.shards.begin(), request.shards.end());
  return write_merged(merge_runs(request.folder, parts, request.overwrite, print_notice), request.execution);
}

}  // namespace

void add_merge(CLI::App& app, Action& action) {
  const auto request = std::make_shared<MergeRequest>();
  CLI::App* command = app.add_subcommand("merge", "Join the shards of a run");
  command->footer(
      "Example: rocking merge out shard1 shard2 shard3\n"
      "copies the realisations of the three folders to out and writes the report, with the bytes of one run, except "
      "`system`. The order of the folders has no influence; shards may overlap if their common realisations agree.");
  command->add_option("DIR", request->folder, "Folder for the whole; created if necessary")->required();
  command->add_option("SHARD", request->shards, "Folders of the parts")->required();
  command->add_flag("--overwrite", request->overwrite,
                    "Replace the run in the folder, after all shards are read and found to agree");
  add_page_choice(*command, request->execution.page);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return merge(*request); }; });
}

}  // namespace rocking::program
