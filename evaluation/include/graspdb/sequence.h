// SPDX-License-Identifier: MIT
// Evaluation sequences: a hand that closes on an object before a moving camera, with ground truth.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "graspdb/camera.h"
#include "graspdb/grasp.h"
#include "graspdb/hand.h"
#include "graspdb/image.h"
#include "graspdb/progress.h"
#include "graspdb/skeleton.h"

namespace graspdb {

// Between keyframes everything is linear in time.
struct Keyframe {
  double time = 0;     // seconds
  double closure = 0;  // 0 rest .. 1 closed on the object
  Eigen::Vector3d view =
      Eigen::Vector3d::Zero();  // yaw, pitch, roll, radians: see camera_from_view
  Eigen::Vector3d palm = Eigen::Vector3d::Zero();  // the palm centre in the camera frame, metres
};

// A sequence as its text file states it (docs/sequences.md).
struct SequenceSpec {
  std::string name;
  std::filesystem::path file;
  std::uint64_t seed = 0;
  double frames_per_second = 10;
  Intrinsics camera;
  double visible_forearm = 0.1;                // metres
  double sensor_noise = 2;                     // standard deviation, grey levels
  Eigen::Vector3d towards_light{0, -0.3, -1};  // camera frame
  Eigen::Vector3d skin_bgr, object_bgr;        // 0..255
  Hand hand;
  Grasp grasp;
  bool object_visible = true;  // false: the same motion with an empty hand
  JointAngles rest;
  std::vector<Keyframe> keyframes;

  int frame_count() const;
};

// yaw, pitch, roll = 0: the back of the hand towards the camera, fingers up. Then yaw turns about
// the camera's y, pitch about its x, roll about its z.
Eigen::Matrix3d camera_from_view(const Eigen::Vector3d& yaw_pitch_roll);

// Reads the sequence, the hand and the grasp that it names. `hand_file` replaces the sequence's own
// hand when not empty. Throws Error naming file and key.
SequenceSpec load_sequence(const std::filesystem::path& file,
                           const std::filesystem::path& hand_file = {});

struct FrameTruth {
  double time = 0;
  Eigen::Matrix3d camera_from_hand;
  Eigen::Vector3d wrist;  // camera frame, metres
  JointAngles angles;
  Keypoints joints;  // camera frame, metres
  double closure = 0;
};

struct SequenceFrame {
  ColorImage color;
  Mask hand;    // visible
  Mask object;  // visible
  FrameTruth truth;
};

// Renders single frames, in any order. Thread-safe.
class SequenceRenderer {
 public:
  // Closes the hand on the sequence's object. Throws Error when the object collides with the hand.
  explicit SequenceRenderer(SequenceSpec spec);

  const SequenceSpec& spec() const { return spec_; }
  FrameTruth truth(int frame) const;
  SequenceFrame render(int frame) const;

 private:
  GraspPose pose(double closure) const;

  SequenceSpec spec_;
  GraspPose closed_;
};

struct NoiseOptions {
  double alpha_percent = 0;
  std::uint64_t seed = 0;
};

// Writes frames/, masks/ (visible hand), noisy/ (the masks with segmentation noise), truth.jsonl
// and sequence.json into `directory`; what an earlier sequence left there is removed first.
void write_sequence(const SequenceRenderer& renderer, const std::filesystem::path& directory,
                    const NoiseOptions& noise, const Progress& progress = {});

// What write_sequence wrote, but for the pictures.
struct WrittenSequence {
  std::filesystem::path directory;
  Intrinsics camera;
  double frames_per_second = 10;
  std::vector<FrameTruth> truth;
};
// Throws Error for what is missing, malformed or not positive.
WrittenSequence read_sequence(const std::filesystem::path& directory);

}  // namespace graspdb
