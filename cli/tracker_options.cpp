// SPDX-License-Identifier: MIT
#include "tracker_options.h"

#include <fmt/format.h>

#include "checks.h"
#include "graspdb/database/search.h"

namespace graspdb::cli {
namespace {

std::vector<std::string> temporal_names() {
  std::vector<std::string> names;
  for (const TemporalModel model : kTemporalModels) names.push_back(temporal_name(model));
  return names;
}

// One value for all models, or each model's own: "20", "none 20, gaussian 20, ...".
template <typename Value>
std::string tuned_default(Value TrackerOptions::*member, DescriptorKind kind) {
  const auto text_of = [&](TemporalModel model) {
    return fmt::format("{:g}", double(tuned_options(model, kind).*member));
  };
  const std::string first = text_of(kTemporalModels[0]);
  std::string all;
  bool same = true;
  for (const TemporalModel model : kTemporalModels) {
    same = same && text_of(model) == first;
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", temporal_name(model), text_of(model));
  }
  return same ? first : all;
}

// Of rows with codes, and of those with HOGs alone.
template <typename Value>
std::string tuned_default(Value TrackerOptions::*member) {
  const std::string codes = tuned_default(member, DescriptorKind::kLearned);
  const std::string hogs = tuned_default(member, DescriptorKind::kHog);
  return codes == hogs ? codes : fmt::format("{}; HOGs: {}", codes, hogs);
}

// An int is read as one: 20.5 neighbours are refused.
template <typename Value>
void add_number(CLI::App& verb, const TrackerNumber& number, Value TrackerOptions::*member,
                std::optional<double>& given) {
  const auto keep = [&given](const Value& value) { given = value; };
  verb.add_option_function<Value>(number.names, keep, number.help)
      ->check(range(static_cast<Value>(number.low), static_cast<Value>(number.high)))
      ->default_str(tuned_default(member));
}

}  // namespace

TrackerOptions TrackerSettings::options(TemporalModel model, const Database& database) const {
  TrackerOptions options = tuned_options(model, descriptor_kind(database));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i]) set_number(options, kTrackerNumbers[i], *numbers[i]);
  }
  return options;
}

void add_tracker_options(CLI::App& verb, TrackerSettings& settings) {
  verb.add_option("--temporal", settings.temporal, "How a frame depends on the one before")
      ->check(one_of(temporal_names()));
  verb.add_option("--search", settings.search, "How neighbours are found")
      ->check(one_of(search_names()));
  for (std::size_t i = 0; i < kTrackerNumbers.size(); ++i) {
    const TrackerNumber& number = kTrackerNumbers[i];
    std::visit([&](auto member) { add_number(verb, number, member, settings.numbers[i]); },
               number.member);
  }
}

}  // namespace graspdb::cli
