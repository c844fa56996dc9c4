// SPDX-License-Identifier: MIT
// The two kinds of failure. Bad input is an Error, which names the file, the key, and what was
// expected and found. A broken contract of our own is a GRASPDB_CHECK. Absence is std::optional.
#pragma once

#include <stdexcept>
#include <string>

namespace graspdb {

// Bad input: the one exception type that users meet. The command line prints what() and exits.
class Error : public std::runtime_error {
 public:
  // What is known about the fault; an empty field is left out of the message.
  struct Fault {
    std::string file;
    std::string key;
    std::string expected;
    std::string found;
  };
  explicit Error(const std::string& message) : std::runtime_error(message) {}
  explicit Error(Fault fault);

  const Fault& fault() const { return fault_; }

 private:
  Fault fault_;
};

// Throws std::logic_error with the place and the text of the condition.
[[noreturn]] void fail_check(const char* condition, const char* file, int line);

}  // namespace graspdb

// States a contract of our own code. It stays on in release builds.
#define GRASPDB_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::graspdb::fail_check(#condition, __FILE__, __LINE__))
