#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "archive.hpp"
#include "arguments.hpp"
#include "output.hpp"
#include "program.hpp"
#include "study_file.hpp"

namespace rocking::program {
namespace {

struct ArchiveRequest {
  std::string folder;
  std::string file;
  bool with_records = false;
  Loudness loudness;
};

ExitCode archive(const ArchiveRequest& request) {
  const std::vector<std::string> names = write_archive(request.folder, request.file, request.with_records);
  print_study(
      request.loudness, facts_text(std::vector<Fact>{{"archive", request.file}, {"files", names}}),
      fmt::format("{}: {} files, which rocking verify checks and computes again\n", request.file, names.size()));
  return ExitCode::done;
}

}  // namespace

void add_archive(CLI::App& app, Action& action) {
  const auto request = std::make_shared<ArchiveRequest>();
  CLI::App* command =
      app.add_subcommand("archive", "Write a finished run as one zip that can be published and verified");
  command->footer(
      "Example: rocking archive out -o run.zip && rocking verify run.zip\n"
      "writes the files of the folder, the experiment, and ro-crate-metadata.json (RO-Crate 1.1), which describes the "
      "run and has the SHA-256 of each file. The same folder gives the same bytes. Name its author and its licence "
      "where you publish it.");
  command->add_option("DIR", request->folder, "Folder of the run")->required()->transform(run_folder());
  command->add_option("-o,--output", request->file, "The archive to be written, in place of an earlier one")
      ->required()
      ->type_name("FILE.zip");
  command->add_flag("--with-records", request->with_records,
                    "Include the ground motions that the experiment names, where they may be published");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return archive(*request); }; });
}

}  // namespace rocking::program
