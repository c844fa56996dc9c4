// SPDX-License-Identifier: MIT
// One view of a hand that pinches an object, as pictures with all their labels:
//   03_render OUTPUT_FOLDER
#include <filesystem>
#include <iostream>

#include "graspdb/pictures/labelled_view.h"
#include "graspdb/pictures/write_view.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("03_render OUTPUT_FOLDER");
  const std::filesystem::path data = GRASPDB_DATA_DIR;  // from CMakeLists.txt
  const graspdb::BuildConfig config{.hands = {data / "assets/hands/male.glb"},
                                    .grasps = data / "grasps",
                                    .only = {9},
                                    .resolution = 512};
  const graspdb::RowPoses poses(config);
  const graspdb::PoseKey closed{.grasp = 9, .step = config.steps};
  const graspdb::Subject subject(poses.hand(0), poses.pose(closed));

  const std::size_t number = 100;  // of config.views, evenly over all rotations
  const graspdb::LabelledView view = subject.seen(poses.camera(subject.pose(), number),
                                                  poses.light(closed, number), graspdb::kAllLayers);
  graspdb::write_view(argv[1], view, {.hand = "male", .variant = "held", .grasp = 9});
  std::cout << "index fingertip at pixel " << view.joints_px.col(8).transpose() << "\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
