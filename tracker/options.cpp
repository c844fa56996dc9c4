// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "graspdb/core/error.h"
#include "graspdb/tracker/tracker.h"
#include "tuned.h"

namespace graspdb {
namespace {

double number_of(const TrackerOptions& options, const TrackerNumber& number) {
  return std::visit([&](auto member) { return static_cast<double>(options.*member); },
                    number.member);
}

}  // namespace

DescriptorKind descriptor_kind(const Database& database) {
  return database.has_embeddings() ? DescriptorKind::kLearned : DescriptorKind::kHog;
}

TrackerOptions tuned_options(TemporalModel temporal, DescriptorKind kind) {
  return kind == DescriptorKind::kHog ? tuned_for_hogs(temporal) : tuned_for_codes(temporal);
}

void set_number(TrackerOptions& options, const TrackerNumber& number, double value) {
  std::visit(
      [&](auto member) {
        options.*member = static_cast<std::decay_t<decltype(options.*member)>>(value);
      },
      number.member);
}

void check_options(const TrackerOptions& options) {
  for (const TrackerNumber& number : kTrackerNumbers) {
    const double value = number_of(options, number);
    if (value >= number.low && value <= number.high) continue;
    throw Error({.key = number.key,
                 .expected = fmt::format("{} to {}", number.low, number.high),
                 .found = fmt::format("{}", value)});
  }
}

}  // namespace graspdb
