#include "study_file.hpp"

#include <fmt/format.h>

#include "rocking/base/utf8.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {

void StudyFile::add_to(CLI::App& command, bool is_required) {
  command.add_option("-o,--output", folder_, fmt::format("Folder for {}; created if necessary", name_))
      ->required(is_required)
      ->type_name("DIR");
  command.add_flag("--overwrite", overwrite_, fmt::format("Replace {} in the folder", name_));
}

void StudyFile::prepare() const {
  if (!is_asked()) return;
  expect_free();
  ensure_writable(folder_);
}

std::string StudyFile::write(std::string_view text) const {
  if (!is_asked()) return "";
  expect_free();
  write_atomically(path(), text);
  return fmt::format("{}: {}\n", label_, path().string());
}

std::string heading(const Experiment& experiment) { return experiment.title.empty() ? "" : experiment.title + "\n\n"; }

void print_study(const Loudness& loudness, std::string_view json, std::string_view table) {
  print_result(loudness.json ? std::string(json) : base::printable(table));
}

}  // namespace rocking::program
