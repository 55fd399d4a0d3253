#include <memory>

#include "campaign.hpp"
#include "commands.hpp"
#include "joining.hpp"

namespace rocking::program {

void add_merge(CLI::App& app, Action& action) {
  const auto request = std::make_shared<MergeRequest>();
  CLI::App* command = app.add_subcommand("merge", "Join the shards of a run");
  command->footer(
      "Example: rocking merge out shard1 shard2 shard3\n"
      "copies the realisations of the three folders to out and writes the report, with the bytes of one run, except "
      "`system`. The order of the folders has no influence; shards may overlap if their common realisations agree.");
  command->add_option("DIR", request->folder, "Folder for the whole; created if necessary")->required();
  command->add_option("SHARD", request->shards, "Folders of the parts")->required();
  command->add_flag("--overwrite", request->overwrite, "Replace the run in the folder, after all shards are joined");
  add_page_choice(*command, request->page);
  add_extent(*command, request->extent);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return join_shards(*request); }; });
}

}  // namespace rocking::program
