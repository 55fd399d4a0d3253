#include "fuzz/attack/run_limited.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rocking::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// A pipe whose ends are closed with the object.
struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  void close_end(std::size_t which) {
    close(ends.at(which));
    ends.at(which) = -1;
  }
  std::array<int, 2> ends{-1, -1};
};

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  const rlimit bound{.rlim_cur = most, .rlim_max = most};
  if (setrlimit(what, &bound) != 0) _exit(127);
}

/// In the new process; does not return. Uses only functions that are allowed between fork and exec.
[[noreturn]] void become(const char* program, char* const* arguments, const char* folder, const Limits& limits,
                         int output, int errors) {
  static const std::array<char*, 5> environment{const_cast<char*>("PATH=/usr/local/bin:/usr/bin:/bin"),
                                                const_cast<char*>("TERM=dumb"), const_cast<char*>("LC_ALL=C.UTF-8"),
                                                const_cast<char*>("TMPDIR=/tmp"), nullptr};
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing < 0 || dup2(nothing, 0) < 0 || dup2(output, 1) < 0 || dup2(errors, 2) < 0 || chdir(folder) != 0)
    _exit(127);
  limit(RLIMIT_CPU, limits.processor_seconds);
  limit(RLIMIT_AS, limits.memory_bytes);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  limit(RLIMIT_CORE, 0);
  execve(program, arguments, environment.data());
  _exit(127);
}

/// Reads both pipes to their ends, or until the time is up. Returns whether both ended.
bool read_all(Pipe& output, Pipe& errors, Ending& ending, Clock::time_point until) {
  std::array<pollfd, 2> ready{pollfd{output.ends[0], POLLIN, 0}, pollfd{errors.ends[0], POLLIN, 0}};
  std::array<std::string*, 2> texts{&ending.output, &ending.errors};
  std::array<char, 65536> chunk{};
  while (ready[0].fd >= 0 || ready[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return false;
    if (poll(ready.data(), ready.size(), static_cast<int>(left)) < 0 && errno != EINTR) return false;
    for (std::size_t i = 0; i < ready.size(); ++i) {
      if (ready.at(i).fd < 0 || ready.at(i).revents == 0) continue;
      const ssize_t count = read(ready.at(i).fd, chunk.data(), chunk.size());
      if (count <= 0) ready.at(i).fd = -1;
      if (count > 0) texts.at(i)->append(chunk.data(), static_cast<std::size_t>(count));
    }
  }
  return true;
}

}  // namespace

Ending run_limited(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   const std::filesystem::path& folder, const Limits& limits) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  Pipe output;
  Pipe errors;
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become(program.c_str(), pointers.data(), folder.c_str(), limits, output.ends[1], errors.ends[1]);
  output.close_end(1);
  errors.close_end(1);

  Ending ending;
  const auto until = Clock::now() + std::chrono::seconds(limits.wall_seconds);
  bool ended = read_all(output, errors, ending, until);
  int status = 0;
  while (ended && waitpid(child, &status, WNOHANG) == 0) {  // its streams are closed, so that it should end
    if (Clock::now() >= until) ended = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (!ended) {
    kill(-child, SIGKILL);  // and the processes that it has started
    waitpid(child, &status, 0);
  }
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.out_of_time = !ended || ending.signal == SIGXCPU || (ending.signal == SIGKILL && ended);
  return ending;
}

}  // namespace rocking::fuzz
