#include "analysis/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;
namespace rocking::analysis {
namespace {

/// A pipe whose ends are closed with this object.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    close_writing();
  }
  [[nodiscard]] int writing() const { return ends_[1]; }
  void close_writing() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  /// Reads until the last writer has closed its end. Throws base::Stopped if it is asked to stop.
  [[nodiscard]] std::string read_all(base::StopRequest stop) const {
    constexpr int between_looks_ms = 50;
    std::string text;
    char buffer[4096];
    for (;;) {
      stop.check();
      pollfd reading{.fd = ends_[0], .events = POLLIN, .revents = 0};
      if (::poll(&reading, 1, between_looks_ms) <= 0) continue;
      const auto count = ::read(ends_[0], buffer, sizeof buffer);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(buffer, static_cast<std::size_t>(count));
    }
  }

 private:
  std::array<int, 2> ends_{};
};

/// The environment of this process with locale C and time zone UTC, without variables that configure gnuplot.
/// SOURCE_DATE_EPOCH is set for libraries that write a date into a PDF: 2000-01-01, as in draw.cpp.
std::vector<std::string> plain_environment() {
  std::vector<std::string> entries{"LC_ALL=C.UTF-8", "TZ=UTC0", "SOURCE_DATE_EPOCH=946684800"};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const bool ours = text.starts_with("LC_") || text.starts_with("GNUPLOT_") || text.starts_with("TZ=") ||
                      text.starts_with("SOURCE_DATE_EPOCH=");
    if (!ours) entries.push_back(text);
  }
  return entries;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Words on one line.
std::string on_one_line(const std::string& words) {
  std::istringstream stream(words);
  std::string line;
  for (std::string word; stream >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  return status;
}

namespace fs = std::filesystem;

constexpr std::string_view beginning_of_name = "rocking-figure-";

/// Opens a folder of this user and locks it. Returns the descriptor, or -1 if another process holds the lock or there
/// is no such folder.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat facts {};
  const bool is_ours = ::fstat(descriptor, &facts) == 0 && facts.st_uid == ::geteuid() && facts.st_nlink > 0;
  if (is_ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

void remove_abandoned_folders(const fs::path& place) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place, fs::directory_options::skip_permission_denied, ignored)) {
    if (!entry.path().filename().string().starts_with(beginning_of_name)) continue;
    const int lock = locked(entry.path());
    if (lock < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(lock);
  }
}

}  // namespace

bool ChildEnd::is_success() const { return error == 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0; }

ChildEnd run_child(const std::filesystem::path& folder, std::vector<std::string> arguments, base::StopRequest stop) {
  std::vector<std::string> environment = plain_environment();
  Pipe said;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, said.writing(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, said.writing(), STDERR_FILENO);
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, arguments.front().c_str(), &actions, nullptr,
                                   pointers_to(arguments).data(), pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return {.error = error, .status = 0, .words = {}};
  said.close_writing();
  std::string words;
  try {
    words = said.read_all(stop);
  } catch (const base::Stopped&) {
    ::kill(process, SIGKILL);
    wait_for(process);
    throw;
  }
  return {.error = 0, .status = wait_for(process), .words = on_one_line(words)};
}

TemporaryFolder::TemporaryFolder() {
  const fs::path place = fs::temp_directory_path();
  remove_abandoned_folders(place);
  // Until it is locked, another process may take the new folder for an abandoned one and remove it; then another one is
  // made.
  for (int attempt = 0;; ++attempt) {
    std::string name = (place / (std::string(beginning_of_name) + "XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), name + ": cannot be created");
    }
    path_ = name;
    lock_ = locked(path_);
    if (lock_ >= 0 || attempt == 3) return;  // a file system without locks: no other process can get one either
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace rocking::analysis
