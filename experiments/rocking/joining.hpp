#pragma once

#include <string>
#include <vector>

#include "campaign.hpp"
#include "exit_code.hpp"

namespace rocking::program {

/// The shards of a run, to be joined in one folder.
struct MergeRequest {
  std::string folder;
  std::vector<std::string> shards;
  Loudness loudness;
  PageChoice page = PageChoice::drawn;
  Extent extent = Extent::one_screen;
  bool overwrite = false;  ///< the run in the folder is replaced when all shards are joined
};

/// Joins the shards and writes the results of the whole. Where realisations are missing, the folder has those that there
/// are. Nothing is written where shards contradict each other.
[[nodiscard]] ExitCode join_shards(const MergeRequest& request);

}  // namespace rocking::program
