// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "checks.h"
#include "graspdb/hand/maker/hand_maker.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/pictures/hand_sheet.h"
#include "graspdb/renderer/image_io.h"
#include "hand_verbs.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct MakeOptions {
  std::string base = "male";
  std::string out;
  WantedMeasures wanted;
};

HandShape shape_of(const MakeOptions& options) {
  HandShape shape = in_proportion(default_hand_shape(options.base), options.wanted);
  shape.name = std::filesystem::path(options.out).stem().string();
  return shape;
}

void run_make(const MakeOptions& options) {
  const Hand hand = make_hand(shape_of(options));
  write_hand(hand, options.out);
  fmt::print("{}: {} triangles, {:.1f} mm from wrist to middle fingertip\n", options.out,
             hand.bind_mesh.triangles.size(), 1000 * hand_length(hand.skeleton));
}

void add_make(CLI::App& verb) {
  auto options = std::make_shared<MakeOptions>();
  CLI::App* make =
      verb.add_subcommand("make", "Make a skinned hand and its rig map from a few measures");
  make->add_option("--out", options->out, "The .glb to write; its rig map goes beside it")
      ->required()
      ->check(output_file({".glb"}));
  make->add_option("--base", options->base, "The default hand to start from")
      ->check(one_of({kDefaultHands.begin(), kDefaultHands.end()}));
  const auto add = [make](const char* name, std::optional<double>& measure,
                          const MeasureRange& measures, const char* text) {
    make->add_option(name, measure, text)
        ->check(range(measures.low, measures.high))
        ->default_str("the base hand's, in proportion");
  };
  WantedMeasures& wanted = options->wanted;
  const MeasureRanges& ranges = kMeasureRanges;
  add("--length-mm", wanted.length_mm, ranges.length_mm, "Wrist joint to middle fingertip, mm");
  add("--breadth-mm", wanted.breadth_mm, ranges.breadth_mm,
      "Across the knuckles without the thumb, mm");
  add("--finger-length-mm", wanted.finger_length_mm, ranges.finger_length_mm,
      "Middle finger from MCP joint to tip, mm");
  add("--finger-breadth-mm", wanted.finger_breadth_mm, ranges.finger_breadth_mm,
      "Index finger at its PIP joint, mm");
  add("--palm-thickness-mm", wanted.palm_thickness_mm, ranges.palm_thickness_mm,
      "Through the middle of the middle finger's metacarpal, mm");
  add("--forearm-breadth-mm", wanted.forearm_breadth_mm, ranges.forearm_breadth_mm,
      "Just behind the wrist, an eighth of the hand's length from it, mm");
  add("--forearm-mm", wanted.forearm_length_mm, ranges.forearm_length_mm,
      "Forearm beyond the wrist joint, mm");
  make->callback([options] { run_make(*options); });
}

struct SheetOptions {
  std::string hand, rig, out;
  bool angles = false;
};

void run_sheet(const SheetOptions& options) {
  const Hand hand =
      options.rig.empty() ? load_hand(options.hand) : load_hand(options.hand, options.rig);
  write_png(options.out, options.angles ? draw_angle_page(hand) : draw_hand_sheet(hand));
  fmt::print("{}\n", options.out);
}

void add_sheet(CLI::App& verb) {
  auto options = std::make_shared<SheetOptions>();
  CLI::App* sheet = verb.add_subcommand("sheet", "Draw a hand in five poses from four sides");
  sheet->add_option("GLB", options->hand, "A rigged hand")->required();
  sheet->add_option("--rig", options->rig, "Its rig map")->default_str("the one beside it");
  sheet->add_flag("--angles", options->angles,
                  "Instead, what each of the 28 angles moves: at zero and at 20 degrees");
  sheet->add_option("--out", options->out, "The PNG to write")
      ->required()
      ->check(output_file({".png"}));
  sheet->callback([options] { run_sheet(*options); });
}

}  // namespace

void add_hand(CLI::App& app) {
  CLI::App* hand = app.add_subcommand("hand", "Make, check and draw rigged hands");
  hand->require_subcommand(1);
  add_make(*hand);
  add_hand_check(*hand);
  add_sheet(*hand);
}

}  // namespace graspdb::cli
