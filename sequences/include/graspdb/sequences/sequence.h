// SPDX-License-Identifier: MIT
// Evaluation sequences: a hand that closes on an object before a moving camera, with ground truth.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/core/progress.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"
#include "graspdb/hand/maker/hand_maker.h"
#include "graspdb/hand/skeleton.h"
#include "graspdb/sequences/meshes.h"

namespace graspdb {

// Between keyframes everything is linear in time.
struct Keyframe {
  double time = 0;     // seconds
  double closure = 0;  // 0 rest .. 1 closed on the object
  Eigen::Vector3d view =
      Eigen::Vector3d::Zero();  // yaw, pitch, roll, radians: see rotation_from_turns
  Eigen::Vector3d palm = Eigen::Vector3d::Zero();  // the palm centre in the camera frame, metres
  // Added to the wrist's flexion and deviation as the grasp has them, radians.
  Eigen::Vector2d wrist = Eigen::Vector2d::Zero();
  Eigen::Vector3d towards_light{0, -0.3, -1};  // camera frame
};

// How things look, whatever their pose.
struct Look {
  Eigen::Vector3d skin_bgr, object_bgr;  // 0..255, where shading is 1
  double ambient = 0.35;                 // the share of light that has no direction
  double skin_mottling = 0;              // how much the skin's albedo varies from place to place
  double blur_px = 0;                    // standard deviation of the lens's blur
  double sensor_noise = 2;               // standard deviation, grey levels
};

// A hand that is made from measures, or one of a file.
struct SequenceHand {
  std::filesystem::path file;  // empty: made
  HandShape shape;
};

// What a sequence may have: its file, or who asks for another rate than the file's.
constexpr double kMinFramesPerSecond = 1, kMaxFramesPerSecond = 240;

// A sequence as its text file states it (docs/sequences.md).
struct SequenceSpec {
  std::string name;
  std::filesystem::path file;
  std::uint64_t seed = 0;
  double frames_per_second = 10;  // may be set to another: the same motion in other steps
  Intrinsics camera;
  double visible_forearm = 0.1;  // metres
  Look look;
  SequenceHand hand;
  Grasp grasp;
  std::optional<int> grasp_type;  // Feix's number of what the grasp is, if it is one of them
  bool object_visible = true;     // false: the same motion with an empty hand
  JointAngles rest;
  std::vector<Keyframe> keyframes;

  int frame_count() const;
};

// A file itself, or all *.seq.toml of a folder by name. Throws Error when there are none.
std::vector<std::filesystem::path> sequence_files(const std::filesystem::path& given);

// Reads the sequence and the grasp that it names. `hand_file` replaces the sequence's own
// hand when not empty. Throws Error naming file and key.
SequenceSpec load_sequence(const std::filesystem::path& file,
                           const std::filesystem::path& hand_file = {});

// The same motion with a grasp of the folder `grasps`: the one whose number is the sequence's
// grasp_type, its object and the folder's rest pose instead of the sequence's own. Nothing when the
// sequence has no type or the folder no grasp of it.
std::optional<SequenceSpec> with_grasp_of_type(SequenceSpec spec,
                                               const std::filesystem::path& grasps);

struct FrameTruth {
  double time = 0;
  RigidTransform camera_from_hand;  // its translation is where the wrist is
  JointAngles angles;
  Keypoints joints;  // camera frame, metres
  double closure = 0;
};

struct SequenceFrame {
  ColorImage color;
  Mask hand;             // visible
  Mask object;           // visible
  double occlusion = 0;  // the share of the hand's pixels that the object hides
  FrameTruth truth;
};

// Renders single frames, in any order. Thread-safe.
class SequenceRenderer {
 public:
  // Makes or loads the hand and closes it on the object (closed_pose()). Throws Error when the
  // object collides with the hand.
  explicit SequenceRenderer(SequenceSpec spec);

  const SequenceSpec& spec() const { return spec_; }
  const Hand& hand() const { return hand_; }  // with the forearm that is visible
  FrameTruth truth(int frame) const;
  FrameGeometry geometry(int frame) const;  // of truth(), render() and mesh_frames()
  SequenceFrame render(int frame) const;

 private:
  Keyframe key(int frame) const;
  FrameGeometry geometry(const Keyframe& key) const;
  FrameTruth truth(const Keyframe& key, const FrameGeometry& geometry) const;
  GraspPose pose(const Keyframe& key) const;

  SequenceSpec spec_;
  Hand hand_;
  GraspPose closed_;
};

// The sequence's hand, with all of its forearm. Throws Error for a file that is not there.
Hand sequence_hand(const SequenceSpec& spec);

struct SequenceNoise {
  double alpha_percent = 0;
  std::uint64_t seed = 0;
};

// Writes frames/, masks/ (visible hand), noisy/ (the masks with segmentation noise), truth.jsonl
// and sequence.json into `directory`. It is new, or holds an earlier sequence and nothing else,
// which goes; else that is an Error.
void write_sequence(const SequenceRenderer& renderer, const std::filesystem::path& directory,
                    const SequenceNoise& noise, const Progress& progress = {});

// What another renderer needs to show the very same hand, object and camera: for write_meshes().
MeshFrames mesh_frames(const SequenceRenderer& renderer);

// What write_sequence wrote, but for the pictures.
struct WrittenSequence {
  std::filesystem::path directory;
  Intrinsics camera;
  double frames_per_second = 10;
  std::vector<FrameTruth> truth;
};
// Throws Error naming file and key for what is missing or is not what write_sequence writes:
// pictures of 1 to 100,000 pixels a side, focal lengths and frames per second above 0.
WrittenSequence read_sequence(const std::filesystem::path& directory);

}  // namespace graspdb
