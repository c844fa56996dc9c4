// SPDX-License-Identifier: MIT
// Loading a rigged hand file (.glb, .fbx, .dae: all that assimp reads) through a rig map.
#pragma once

#include <filesystem>

#include "graspdb/hand.h"

namespace graspdb {

// The rig map that lies beside a hand file: male.glb -> male.rig.toml. docs/hands.md describes it.
std::filesystem::path rig_map_beside(const std::filesystem::path& hand_file);

// Reads mesh, weights and joint positions from `hand_file`, and everything else that a hand is
// (frames, zero pose) from the joint positions and the rig map; the file's own bone axes are
// ignored. A left hand is mirrored into a right one. Throws Error naming the file and the bone or
// key.
Hand load_hand(const std::filesystem::path& hand_file, const std::filesystem::path& rig_map);
Hand load_hand(const std::filesystem::path& hand_file);

}  // namespace graspdb
