// Loaded into a program by LD_PRELOAD. Kills it just before its N-th call that renames, links, makes or removes a file or
// folder, with N from the environment variable KILL_AT. Tests thus see a folder as a kill at every moment leaves it. Waits
// SLOW_LOCKS microseconds after each lock of a file that it takes or gives back: others come in between.

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

void count_call() {
  static const long last = std::atol(std::getenv("KILL_AT") != nullptr ? std::getenv("KILL_AT") : "0");
  static std::atomic<long> calls{0};
  if (++calls == last) ::kill(::getpid(), SIGKILL);
}

template <class Function, class... Arguments>
int pass_on(const char* name, Arguments... arguments) {
  count_call();
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name))(arguments...);
}

int lock(const char* name, int file, int command, void* argument) {
  static const long wait = std::atol(std::getenv("SLOW_LOCKS") != nullptr ? std::getenv("SLOW_LOCKS") : "0");
  const int found = reinterpret_cast<int (*)(int, int, ...)>(::dlsym(RTLD_NEXT, name))(file, command, argument);
  if (wait > 0 && (command == F_SETLK || command == F_SETLKW)) ::usleep(static_cast<unsigned>(wait));
  return found;
}

}  // namespace

extern "C" {

int fcntl(int file, int command, ...) {
  std::va_list arguments;
  va_start(arguments, command);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  return lock("fcntl", file, command, argument);
}
int fcntl64(int file, int command, ...) {
  std::va_list arguments;
  va_start(arguments, command);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  return lock("fcntl64", file, command, argument);
}

int rename(const char* from, const char* to) { return pass_on<decltype(::rename)>("rename", from, to); }
int unlink(const char* path) { return pass_on<decltype(::unlink)>("unlink", path); }
int unlinkat(int folder, const char* path, int flags) {
  return pass_on<decltype(::unlinkat)>("unlinkat", folder, path, flags);
}
int remove(const char* path) { return pass_on<decltype(::remove)>("remove", path); }
int link(const char* from, const char* to) { return pass_on<decltype(::link)>("link", from, to); }
int mkdir(const char* path, mode_t mode) {
  using Mkdir = int(const char*, mode_t);
  return pass_on<Mkdir>("mkdir", path, mode);
}
}
