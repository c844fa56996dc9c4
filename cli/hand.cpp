// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "graspdb/hand_maker.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct Options {
  std::string base = "male";
  std::string out;
  double length_mm = 0, breadth_mm = 0;  // 0: the base shape's
  double finger_length = 0, finger_thickness = 0, palm_thickness = 0, forearm_thickness = 0;
};

HandShape shape_of(const Options& options) {
  HandShape shape = default_hand_shape(options.base);
  const auto replace = [](double& value, double wanted) {
    if (wanted > 0) value = wanted;
  };
  replace(shape.length_mm, options.length_mm);
  replace(shape.breadth_mm, options.breadth_mm);
  replace(shape.finger_length, options.finger_length);
  replace(shape.finger_thickness, options.finger_thickness);
  replace(shape.palm_thickness, options.palm_thickness);
  replace(shape.forearm_thickness, options.forearm_thickness);
  shape.name = std::filesystem::path(options.out).stem().string();
  return shape;
}

void run_make(const Options& options) {
  const Hand hand = make_hand(shape_of(options));
  write_hand(hand, options.out);
  fmt::print("{}: {} triangles, {:.1f} mm from wrist to middle fingertip\n", options.out,
             hand.bind_mesh.triangles.size(), 1000 * hand_length(hand.skeleton));
}

}  // namespace

void add_hand(CLI::App& app) {
  CLI::App* hand = app.add_subcommand("hand", "Make rigged hands");
  hand->require_subcommand(1);
  auto options = std::make_shared<Options>();
  CLI::App* make =
      hand->add_subcommand("make", "Make a skinned hand and its rig map from a few measures");
  make->add_option("--out", options->out, "The .glb to write; its rig map goes beside it")
      ->required();
  make->add_option("--base", options->base, "The default hand to start from")
      ->check(CLI::IsMember({"male", "female", "slender", "child"}));
  const auto add = [make](const char* name, double& value, const char* text, double low,
                          double high) {
    make->add_option(name, value, text)
        ->check(CLI::Range(low, high))
        ->default_str("the base hand's");
  };
  add("--length-mm", options->length_mm, "Wrist joint to middle fingertip, mm", 100, 240);
  add("--breadth-mm", options->breadth_mm, "Across the knuckles without the thumb, mm", 40, 120);
  add("--finger-length", options->finger_length, "Factor on the fingers' length", 0.8, 1.2);
  add("--finger-thickness", options->finger_thickness, "Factor on the fingers' thickness", 0.7,
      1.3);
  add("--palm-thickness", options->palm_thickness, "Factor on the palm's thickness", 0.7, 1.3);
  add("--forearm-thickness", options->forearm_thickness, "Factor on the forearm's thickness", 0.7,
      1.3);
  make->callback([options] { run_make(*options); });
}

}  // namespace graspdb::cli
