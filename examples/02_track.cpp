// SPDX-License-Identifier: MIT
// The pose of the right hand in each picture of a video, one after the other:
//   02_track hands.graspdb 000000.png 000001.png ...
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/tracker/hand_reader.h"

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("02_track hands.graspdb PICTURE ...");
  const auto database = graspdb::Database::open(argv[1]);
  graspdb::HandReader reader(database);
  for (int i = 2; i < argc; ++i) {
    const cv::Mat picture = cv::imread(argv[i], cv::IMREAD_COLOR);
    if (picture.empty()) throw std::runtime_error(argv[i] + std::string(": no picture"));
    const auto frame = graspdb::to_color_image(picture);

    // Better than a guess: the intrinsics of your calibrated camera.
    const auto camera = graspdb::guess_camera(frame.width(), frame.height());
    const graspdb::Estimate hand = reader.read(frame, camera);

    std::cout << argv[i] << ": ";
    if (!hand.valid) {
      std::cout << "no hand\n";
      continue;
    }
    std::cout << "grasp " << hand.grasp << ", confidence " << hand.confidence << ", wrist at "
              << hand.camera_from_hand.translation.transpose() << " m, index fingertip at pixel "
              << hand.joints_px.col(8).transpose() << "\n";
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
