// SPDX-License-Identifier: MIT
// Loading a rigged hand file (.glb, .fbx, .dae: all that assimp reads) through a rig map.
#pragma once

#include <filesystem>

#include "graspdb/hand.h"

namespace graspdb {

// The rig map that lies beside a hand file: male.glb -> male.rig.toml. Its keys:
//   handedness       "right" or "left"
//   metres_per_unit  1 when absent
//   thumb_nail       the way the nail faces at rest, three numbers in the file's coordinates
//   [bones]          for each bone_name() a list of the file's bones: the joint is the first one's
//                    origin (the palm's is the wrist, the forearm's lies nearer the elbow), and the
//                    skin of all of them follows it. Every bone that moves skin must be named.
//   [tips]           thumb, index, middle, ring, little: the joint at the tip of each
std::filesystem::path rig_map_beside(const std::filesystem::path& hand_file);

// Reads mesh, weights and joint positions from `hand_file`, and everything else that a hand is
// (frames, zero pose) from the joint positions and the rig map; the file's own bone axes are
// ignored. A left hand is mirrored into a right one. Throws Error naming the file and the bone or
// key.
Hand load_hand(const std::filesystem::path& hand_file, const std::filesystem::path& rig_map);
Hand load_hand(const std::filesystem::path& hand_file);

}  // namespace graspdb
