// SPDX-License-Identifier: MIT
// What a rigged file holds before it becomes a Hand: the lines of a hand's check that loading would
// hide, because it normalises weights and follows the file's rest pose.
#pragma once

#include <filesystem>
#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

//   weight sum      the largest distance of the sum of a vertex' weights from 1
//   least weight    the smallest weight of any bone on any vertex
//   bones a vertex  the most bones with a weight above 1e-6 (importers give idle joints smaller
//                   ones)
//   bind identity   a bone's pose in the file, times its offset (the inverse of its pose when the
//                   skin was bound), is the identity or the pose of the node that holds the mesh,
//                   and so the same for all bones. The largest entry that differs; of the
//                   translation in units of the skin's largest side
// Throws Error when the file is unreadable or has no skin.
std::vector<HandCheckLine> check_hand_file(const std::filesystem::path& hand_file);

// The program that wrote the file, as it says itself; empty when it does not. Throws Error.
std::string hand_file_generator(const std::filesystem::path& hand_file);

}  // namespace graspdb
