// SPDX-License-Identifier: MIT
// All that training pictures depend on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace graspdb {

// Shares are between 0 and 1. An amplitude of 0 leaves that variation out.
struct SampleConfig {
  std::vector<std::filesystem::path> hands;  // .glb files; empty: the four default hands
  std::filesystem::path grasps;              // the folder of grasp files; empty: the project's own
  std::vector<int> leave_out;                // ids of grasps that are never shown
  int seed = 0;
  int views_per_pose = 64;
  int poses_per_hand = 128;

  // Hands and poses.
  double made_hands = 0.6;  // the share of hands that are made from drawn measures
  double held = 0.55;       // the share of poses that hold an object; the others are free
  double gestures = 0.5;    // of the free ones: each digit straight, bent or curled by itself
  double mixtures = 0.3;    // of the free ones: two grasps blended, or digit by digit
  double angles_deg = 8;    // standard deviation of what is added to the digits' angles
  double wrist_deg = 20;    // and to the wrist's
  double object_size_percent = 15;  // how much the object may be smaller, a third of it larger
  double forearm_mm = 200;          // longest visible forearm, or what a sleeve leaves of it

  // Pictures.
  double nearest_m = 0.35, farthest_m = 1.2;  // camera to palm
  int smallest_px = 72, largest_px = 160;     // side of the picture
  double light = 1;   // 1: any direction, strength, width, and shadows; 0: that of rows
  double skin = 1;    // patches of the skin, the curve of grey levels
  double sensor = 1;  // blur and noise

  // Masks that err. A share of the pictures has a true one, as rows have.
  double true_masks = 0.25;
  double occluders = 0.2;    // the share with another object before the hand
  double wrist_cut_mm = 40;  // by how much the forearm is cut off too early or too late
  double noise_percent = 4;  // of dropped pixels, at most
  double torn = 0.3;         // the share with lost pieces and added blobs
  double outline_px = 1.5;   // by how much an outline is too thin or too fat, at a side of 128
};

// A TOML file with the same keys, where an absent one means its default; paths are seen from the
// file, or from the data directory. Throws Error naming file and key.
SampleConfig load_sample_config(const std::filesystem::path& file);

// As JSON, for the files that are made.
std::string sample_config_json(const SampleConfig& config);

}  // namespace graspdb
