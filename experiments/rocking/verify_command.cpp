#include <memory>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "archive.hpp"
#include "folder_check.hpp"
#include "program.hpp"
#include "study_file.hpp"

namespace rocking::program {
namespace {

/// Of an archive whose files are as they were written.
FolderCheck check_of_archive(VerifyRequest request) {
  const UnpackedArchive archive(request.folder);
  if (!archive.faults().empty()) return {.facts = {}, .table = {}, .findings = archive.faults()};
  request.folder = archive.folder().string();
  return check_of(request);
}

ExitCode verify(VerifyRequest request) {
  request.name = request.folder;
  FolderCheck check = request.name.ends_with(".zip") ? check_of_archive(request) : check_of(request);
  const bool right = check.findings.empty();
  std::vector<Fact> facts{{"verified", right}};
  facts.insert(facts.end(), check.facts.begin(), check.facts.end());
  facts.push_back({"findings", check.findings});
  if (!right) check.table = fmt::format("{}: not verified\n  {}\n", request.name, fmt::join(check.findings, "\n  "));
  print_study(request.execution.loudness, facts_text(facts), check.table);
  return right ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  const auto request = std::make_shared<VerifyRequest>();
  CLI::App* command = app.add_subcommand("verify", "Run a finished run again and compare the bits");
  command->footer(
      "Example: rocking verify out --sample 100\n"
      "checks that out/report.json follows from out/realisations.sqlite, and that about a hundred of its realisations "
      "give the same bits when they are run again. Of an archive (rocking archive) the digests of its files are "
      "checked first. Without --sample all of them are run. Without the store, the report is compared with a new run. "
      "An out/rare.json is checked, too: by its pilot runs and some of its repetitions; an out/infer.json by some "
      "points of its design.");
  command->add_option("DIR", request->folder, "Folder of the run, or its archive, FILE.zip")
      ->required()
      ->transform(run_folder());
  command
      ->add_option("--sample", request->sample,
                   "Run about N realisations again, N repetitions of rare.json and N points of infer.json, evenly "
                   "spaced; default: all realisations, 4 repetitions of each condition, 8 points")
      ->check(whole_number(1, largest_sample))
      ->type_name("N");
  add_threads(*command, request->execution);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return verify(*request); }; });
}

}  // namespace rocking::program
