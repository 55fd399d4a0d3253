// Loaded into a program by LD_PRELOAD. Kills it just before its N-th call that renames, links, makes or removes a file or
// folder, with N from the environment variable KILL_AT. Tests thus see a folder as a kill at every moment leaves it.

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>
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

}  // namespace

extern "C" {

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
