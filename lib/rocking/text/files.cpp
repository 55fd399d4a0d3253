#include "rocking/text/files.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "rocking/base/regular_file.hpp"

namespace rocking {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw std::system_error(errno, std::generic_category(), path.string() + ": " + what);
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int close() { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

constexpr std::string_view temporary_name = ".rocking-";
constexpr std::size_t written_at_once = 65536;  // bytes

// A file with a unique name, removed unless it is renamed. Its lock shows that its process is running.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder) : descriptor_(make_in(folder)) {
    if (descriptor_.number() < 0) fail(folder, "cannot create a file here");
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const auto written = ::write(descriptor_.number(), content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(name_, "cannot be written");
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void rename_to(const std::filesystem::path& path) {
    if (::fsync(descriptor_.number()) != 0) fail(name_, "cannot be flushed to the disk");
    if (descriptor_.close() != 0) fail(name_, "cannot be closed");
    if (::rename(name_.c_str(), path.c_str()) != 0) fail(path, "cannot be replaced");
    name_.clear();
  }

 private:
  // The first free name of this process. mkstemp would deny access to users whom the umask allows.
  int make_in(const std::filesystem::path& folder) {
    for (int number = 0;; ++number) {
      name_ =
          (folder / (std::string(temporary_name) + std::to_string(::getpid()) + '-' + std::to_string(number))).string();
      const int descriptor = ::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0 && is_locked_and_named(descriptor)) return descriptor;
      if (descriptor >= 0) ::close(descriptor);
      if (descriptor < 0 && errno != EEXIST) return descriptor;
    }
  }

  // False if another process took the file for an abandoned one before it was locked, and removed it.
  static bool is_locked_and_named(int descriptor) {
    static_cast<void>(::flock(descriptor, LOCK_EX | LOCK_NB));
    struct stat facts {};
    return ::fstat(descriptor, &facts) == 0 && facts.st_nlink > 0;
  }

  std::string name_;
  FileDescriptor descriptor_;
};

// Those of running processes are locked and remain.
void remove_abandoned_files(const std::filesystem::path& folder) {
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    if (!entry.path().filename().string().starts_with(temporary_name)) continue;
    const FileDescriptor file(::open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file.number() < 0 || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) continue;
    ::unlink(entry.path().c_str());
  }
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  base::expect_regular_file(path);
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, "cannot be opened");
  std::string content;
  struct stat facts {};
  if (::fstat(file.number(), &facts) == 0) content.reserve(std::min(most, static_cast<std::size_t>(facts.st_size)));
  char buffer[65536];
  while (content.size() <= most) {
    const auto count = ::read(file.number(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "cannot be read");
    if (count == 0) break;
    content.append(buffer, static_cast<std::size_t>(count));
  }
  return content;
}

FileSource files_seen_from(const std::filesystem::path& folder) {
  return [folder](const std::string& name, std::size_t most) { return read_file(folder / name, most); };
}

FileMatches matches_seen_from(const std::filesystem::path& folder) {
  return [folder](const std::string& pattern) {
    const std::filesystem::path within = std::filesystem::path(pattern).parent_path();
    const std::string wanted = std::filesystem::path(pattern).filename().string();
    std::vector<std::string> names;
    std::error_code unreadable;
    const std::filesystem::path place = folder / within;
    for (const auto& entry : std::filesystem::directory_iterator(place.empty() ? "." : place, unreadable)) {
      const std::string name = entry.path().filename().string();
      std::error_code gone;
      if (::fnmatch(wanted.c_str(), name.c_str(), FNM_PERIOD | FNM_NOESCAPE | FNM_CASEFOLD) != 0 ||
          !entry.is_regular_file(gone)) {
        continue;
      }
      names.push_back((within / name).string());
    }
    std::sort(names.begin(), names.end());
    return names;
  };
}

void write_atomically(const std::filesystem::path& path, std::string_view content) {
  write_atomically(path, [content](const TextSink& sink) { sink(content); });
}

void write_atomically(const std::filesystem::path& path, const std::function<void(const TextSink& sink)>& write) {
  const std::filesystem::path folder = folder_of(path);
  TemporaryFile file(folder);
  std::string waiting;  // a JSON document comes in pieces of a few letters
  write([&](std::string_view piece) {
    waiting += piece;
    if (waiting.size() < written_at_once) return;
    file.write(waiting);
    waiting.clear();
  });
  file.write(waiting);
  file.rename_to(path);
  // The new name is on the disk only after the folder is flushed.
  const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.number() >= 0) ::fsync(directory.number());
}

void ensure_writable(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::system_error(error, folder.string() + ": cannot create this folder");
  if (!std::filesystem::is_directory(folder)) {
    throw std::system_error(std::make_error_code(std::errc::not_a_directory), folder.string() + ": is not a folder");
  }
  const TemporaryFile probe(folder);
  remove_abandoned_files(folder);
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:+=@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

}  // namespace rocking
