#include "study_file.hpp"

#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::program {

void StudyFile::add_to(CLI::App& command, bool is_required) {
  command.add_option("-o,--output", folder_, fmt::format("Folder for {}; created if necessary", name_))
      ->required(is_required)
      ->type_name("DIR");
  command.add_flag("--overwrite", overwrite_, fmt::format("Replace {} in the folder", name_));
}

void StudyFile::add_resume(CLI::App& command, std::string_view kept) {
  can_resume_ = true;
  command.add_flag("--resume", resumes_, fmt::format("Go on from the {} in DIR/{}, if it is there", kept, name_));
}

void StudyFile::expect_free(const std::filesystem::path& other) const {
  if (overwrite_ || resumes_ || !std::filesystem::exists(other)) return;
  throw InTheWay(fmt::format("{}: already exists; choose another folder, or add {}--overwrite to replace it",
                             other.string(), can_resume_ ? "--resume to go on from it, or " : ""));
}

void StudyFile::prepare() {
  if (!is_asked()) return;
  expect_free();
  ensure_writable(folder_);
  auto lock = FolderLock::of_file(path());
  if (!lock) {
    throw InTheWay(path().string() +
                   ": another `rocking` is working on this file; wait for it, or choose another folder");
  }
  lock_.emplace(*std::move(lock));
  expect_free();  // another one may have finished it meanwhile
  keeps_ = resumes_ || !std::filesystem::exists(path());
}

void StudyFile::keep(const std::function<std::string()>& text) {
  constexpr std::chrono::seconds between(10);
  if (!keeps_ || std::chrono::steady_clock::now() < next_keep_) return;
  try {
    write_atomically(path(), text());
    resumes_ = true;  // the file is now that of this call
  } catch (const std::system_error&) {
    // The disk may be full.
  }
  next_keep_ = std::chrono::steady_clock::now() + between;
}

void StudyFile::read_earlier(const std::function<void(const Json&)>& use) const {
  const std::string text = read_file(path());
  try {
    use(parse_json(text));
  } catch (const base::InputError& error) {
    std::vector<base::Problem> problems = located(error, text, path().string()).problems();
    for (base::Problem& problem : problems) {
      if (problem.remedy.find("--overwrite") != std::string::npos) continue;
      problem.remedy +=
          (problem.remedy.empty() ? "" : ", or ") + std::string("`--overwrite` without `--resume` begins anew");
    }
    throw base::InputError(std::move(problems));
  }
}

std::string StudyFile::write(std::string_view text) const {
  if (!is_asked()) return "";
  expect_free();
  write_atomically(path(), text);
  return fmt::format("{}: {}\n", label_, path().string());
}

std::string heading(const Experiment& experiment) { return experiment.title.empty() ? "" : experiment.title + "\n\n"; }

void print_study(const Loudness& loudness, std::string_view json, std::string_view table) {
  loudness.json ? print_result(json) : print_text(table);
}

void deliver_study(const Loudness& loudness, std::string_view json, std::string table,
                   const std::function<std::string()>& write) {
  std::exception_ptr failure;
  try {
    table += write();
  } catch (const std::system_error&) {
    failure = std::current_exception();
  } catch (const InTheWay&) {
    failure = std::current_exception();
  }
  print_study(loudness, json, table);
  if (!failure) return;
  if (!loudness.json) {
    print_notice("the result could not be written to its file, and follows on standard output as JSON");
    print_result(json);
  }
  std::rethrow_exception(failure);
}

}  // namespace rocking::program
