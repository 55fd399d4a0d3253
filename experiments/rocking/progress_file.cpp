#include "progress_file.hpp"

#include <system_error>
#include <utility>

#include <unistd.h>

#include "rocking/text/files.hpp"

namespace rocking::program {
namespace {

constexpr std::chrono::seconds between_notes(5);

}  // namespace

ProgressFile::ProgressFile(std::filesystem::path path) : path_(std::move(path)), start_(Clock::now()), next_(start_) {}

ProgressFile::~ProgressFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void ProgressFile::note(std::uint64_t done, std::uint64_t all) {
  if (!done_before_) done_before_ = done;
  if (done == all || Clock::now() < next_) return;  // after the last realisation the file is removed at once
  next_ = Clock::now() + between_notes;
  const ProgressNote note{.process = static_cast<std::uint64_t>(::getpid()),
                          .elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count(),
                          .done_before = *done_before_,
                          .done = done,
                          .all = all};
  try {
    write_atomically(path_, to_text(note));
  } catch (const std::system_error&) {
    // The disk is full or missing; the store reports that where it matters.
  }
}

}  // namespace rocking::program
