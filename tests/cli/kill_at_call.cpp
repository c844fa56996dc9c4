// SPDX-License-Identifier: MIT
// Preloaded into a program, it ends the program as kill -9 does, just before call number
// GRASPDB_KILL_AT of those that change files: open for writing, write, fsync, rename, unlink.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace {

std::atomic<long> g_calls = 0;

void count_call() {
  static const char* const wanted = std::getenv("GRASPDB_KILL_AT");
  if (wanted != nullptr && ++g_calls == std::atol(wanted)) ::raise(SIGKILL);
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if ((flags & (O_WRONLY | O_RDWR)) != 0) count_call();
  return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (file > STDERR_FILENO) count_call();
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

int fsync(int file) {
  count_call();
  return next<int(int)>("fsync")(file);
}

int rename(const char* from, const char* to) {
  count_call();
  return next<int(const char*, const char*)>("rename")(from, to);
}

int unlink(const char* path) {
  count_call();
  return next<int(const char*)>("unlink")(path);
}

// How often the calls above were made, for a run that is not killed.
__attribute__((destructor)) void tell_calls() {
  if (std::getenv("GRASPDB_COUNT_CALLS") != nullptr) {
    std::fprintf(stderr, "file calls: %ld\n", g_calls.load());
  }
}
}
