// SPDX-License-Identifier: MIT
#include "graspdb/pictures/grasp_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kSideTile = 300;  // pixels
constexpr int kStepTile = 180;
constexpr int kPageTile = 230;

// The two that tell most: into the hand from above the finger tips, and from below the thumb.
const Side kFromAbove = {"from above", {0.7, -0.5, 0.7}, {0, 1, 0}};
const Side kFromBelow = {"from below", {0.45, 0.35, 0.9}, {0, 1, 0}};

}  // namespace

ColorImage draw_grasp_sheet(const Hand& hand, const Grasp& grasp, const JointAngles& rest,
                            const GraspPose& closed) {
  constexpr int kColumns = 3, kTitle = 30;
  constexpr int kStepsTop = kTitle + 2 * kSideTile;
  Page page(kColumns * kSideTile, kStepsTop + kStepTile);
  const ModelView model(hand, closed, grasp.object.get());
  const std::array<Side, 6> around = {sides::kPalm,       sides::kThumb,
                                      sides::kBack,       sides::kLittleFinger,
                                      sides::kFingerTips, sides::kThumbAndPalm};
  for (int i = 0; i < static_cast<int>(around.size()); ++i) {
    const Side& side = around[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kSideTile, y = kTitle + i / kColumns * kSideTile;
    page.place(model.seen(side, kSideTile), x, y);
    page.write(side.name, x + 8, y + kSideTile - 8);
  }
  for (int step = 1; step <= kStepCount; ++step) {
    const ModelView stepped(hand, pose_at_step(grasp, rest, closed, step), grasp.object.get());
    const int x = (step - 1) * kStepTile;
    page.place(stepped.seen(sides::kThumb, kStepTile), x, kStepsTop);
    page.write(fmt::format("step {}", step), x + 8, kStepsTop + 16);
  }
  page.write(fmt::format("{} {}: {}", grasp.id, grasp.name, grasp.object_name), 8, 20);
  return page.image();
}

ColorImage draw_grasp_page(const Hand& hand, const std::vector<Grasp>& grasps,
                           const std::map<int, GraspPose>& closed, bool plain) {
  constexpr int kColumns = 3, kTileWidth = 2 * kPageTile;
  const int title = plain ? 0 : 24;
  const int rows = (static_cast<int>(grasps.size()) + kColumns - 1) / kColumns;
  Page page(kColumns * kTileWidth, rows * (kPageTile + title));
  for (int i = 0; i < static_cast<int>(grasps.size()); ++i) {
    const Grasp& grasp = grasps[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kTileWidth, y = i / kColumns * (kPageTile + title);
    const ModelView model(hand, closed.at(grasp.id), grasp.object.get());
    page.place(model.seen(kFromAbove, kPageTile), x, y + title);
    page.place(model.seen(kFromBelow, kPageTile), x + kPageTile, y + title);
    if (!plain) page.write(fmt::format("{} {}", grasp.id, grasp.name), x + 8, y + 17);
  }
  return page.image();
}

ColorImage draw_step_page(const Hand& hand, const std::vector<Grasp>& grasps,
                          const JointAngles& rest, const std::map<int, GraspPose>& closed,
                          bool plain) {
  constexpr int kColumns = 2, kRowWidth = kStepCount * kStepTile;
  const int title = plain ? 0 : 24;
  const int rows = (static_cast<int>(grasps.size()) + kColumns - 1) / kColumns;
  Page page(std::min(kColumns, static_cast<int>(grasps.size())) * kRowWidth,
            rows * (kStepTile + title));
  for (int i = 0; i < static_cast<int>(grasps.size()); ++i) {
    const Grasp& grasp = grasps[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kRowWidth, y = i / kColumns * (kStepTile + title);
    std::vector<ModelView> models;
    Framed framed;
    for (int step = 1; step <= kStepCount; ++step) {
      const GraspPose pose = pose_at_step(grasp, rest, closed.at(grasp.id), step);
      const Framed& shown = models.emplace_back(hand, pose, grasp.object.get()).framed();
      framed.insert(framed.end(), shown.begin(), shown.end());
    }
    for (int step = 0; step < kStepCount; ++step) {
      const ModelView& model = models[static_cast<std::size_t>(step)];
      page.place(model.seen(kFromAbove, kStepTile, framed), x + step * kStepTile, y + title);
    }
    if (!plain) page.write(fmt::format("{} {}", grasp.id, grasp.name), x + 8, y + 17);
  }
  return page.image();
}

}  // namespace graspdb
