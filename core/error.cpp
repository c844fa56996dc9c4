// SPDX-License-Identifier: MIT
#include "graspdb/core/error.h"

#include <fmt/format.h>

namespace graspdb {
namespace {

std::string describe(const Error::Fault& fault) {
  std::string text = fault.file;
  const auto add = [&text](const char* separator, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += separator;
    text += part;
  };
  add(": ", fault.key.empty() ? "" : fmt::format("'{}'", fault.key));
  add(": ", fault.expected.empty() ? "" : "expected " + fault.expected);
  add(fault.expected.empty() ? ": " : ", ", fault.found.empty() ? "" : "found " + fault.found);
  return text;
}

}  // namespace

Error::Error(Fault fault) : std::runtime_error(describe(fault)), fault_(std::move(fault)) {}

void fail_check(const char* condition, const char* file, int line) {
  throw std::logic_error(fmt::format("{}:{}: check failed: {}", file, line, condition));
}

}  // namespace graspdb
