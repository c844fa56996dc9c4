// SPDX-License-Identifier: MIT
#include "graspdb/hand/check/hand_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "checks.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/check/hand_file_check.h"
#include "graspdb/hand/maker/hand_maker.h"
#include "graspdb/hand/rig/rig.h"
#include "hand_verbs.h"

namespace graspdb::cli {
namespace {

using Status = HandCheckLine::Status;

struct HandCheckArguments {
  std::string file, rig;
  double length_mm = 0, breadth_mm = 0;  // 0: not told
  bool json = false;
};

// The shape of one of the four hands, when the file is one: it carries its name, and says that
// graspdb wrote it.
std::optional<HandShape> shape_of(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  const bool named =
      std::find(kDefaultHands.begin(), kDefaultHands.end(), name) != kDefaultHands.end();
  if (!named || hand_file_generator(file) != "graspdb") return std::nullopt;
  return default_hand_shape(name);
}

std::optional<AskedSize> asked_size(const HandCheckArguments& options,
                                    const std::optional<HandShape>& shape) {
  if (options.length_mm > 0) return AskedSize{options.length_mm, options.breadth_mm};
  if (shape) return AskedSize{shape->length_mm, shape->breadth_mm};
  return std::nullopt;
}

std::vector<HandCheckLine> lines_of(const HandCheckArguments& options, const Hand& hand) {
  const std::optional<HandShape> shape = shape_of(options.file);
  std::vector<HandCheckLine> lines = check_hand_file(options.file);
  const std::vector<HandCheckLine> of_hand = check_hand(hand, asked_size(options, shape));
  lines.insert(lines.end(), of_hand.begin(), of_hand.end());
  std::optional<Hand> made;
  if (shape) made = make_hand(*shape);
  lines.push_back(check_made_again(hand, made));
  return lines;
}

nlohmann::json to_json(const HandCheckLine& line) {
  nlohmann::json entry = {{"name", line.name},
                          {"value", nullptr},
                          {"unit", line.unit},
                          {"gate", line.gate},
                          {"status", status_name(line.status)},
                          {"why", line.why}};
  if (std::isfinite(line.value)) entry["value"] = line.value;
  return entry;
}

void print(const HandCheckLine& line) {
  const std::string_view verdict = line.status == Status::kPass   ? "ok"
                                   : line.status == Status::kFail ? "FAIL"
                                                                  : "n/a";
  const std::string value =
      std::isnan(line.value) ? "-" : fmt::format("{:.4g} {}", line.value, line.unit);
  const std::string text =
      fmt::format("{:4} {:37} {:>13}  {:14} {}", verdict, line.name, value, line.gate, line.why);
  fmt::print("{}\n", text.substr(0, text.find_last_not_of(' ') + 1));
}

void run(const HandCheckArguments& options) {
  const Hand hand =
      options.rig.empty() ? load_hand(options.file) : load_hand(options.file, options.rig);
  const std::vector<HandCheckLine> lines = lines_of(options, hand);
  if (options.json) {
    nlohmann::json list = nlohmann::json::array();
    for (const HandCheckLine& line : lines) list.push_back(to_json(line));
    const nlohmann::json whole = {{"hand", hand.name},
                                  {"triangles", hand.bind_mesh.triangles.size()},
                                  {"pass", passes(lines)},
                                  {"lines", list}};
    fmt::print("{}\n", whole.dump(1));
  } else {
    for (const HandCheckLine& line : lines) print(line);
  }
  const auto failed = std::count_if(lines.begin(), lines.end(), [](const HandCheckLine& line) {
    return line.status == Status::kFail;
  });
  if (failed > 0) {
    throw Error(fmt::format("{}: {} of {} lines fail", options.file, failed, lines.size()));
  }
}

}  // namespace

void add_hand_check(CLI::App& hand) {
  auto options = std::make_shared<HandCheckArguments>();
  CLI::App* check = hand.add_subcommand(
      "check", "Measure a rigged hand: surface, skin, reach and angles; exit 1 when a gate fails");
  check->add_option("GLB", options->file, "The hand: .glb, .fbx, .dae")->required();
  check->add_option("--rig", options->rig, "Its rig map")->default_str("the one beside it");
  CLI::Option* length =
      check->add_option("--length-mm", options->length_mm, "What it should measure, mm")
          ->check(range(100.0, 240.0))
          ->default_str("as made");
  CLI::Option* breadth =
      check->add_option("--breadth-mm", options->breadth_mm, "What it should measure, mm")
          ->check(range(40.0, 120.0))
          ->default_str("as made");
  length->needs(breadth);
  breadth->needs(length);
  check->add_flag("--json", options->json, "As JSON");
  check->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
