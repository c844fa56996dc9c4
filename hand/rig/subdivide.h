// SPDX-License-Identifier: MIT
#pragma once

#include "rig_skin.h"

namespace graspdb {

// Halves edges, the longest first, until none is longer than `longest_edge` metres. New vertices
// lie where the surface curves through the old ones by their normals (Boubekeur, Alexa: Phong
// Tessellation, SIGGRAPH Asia 2008); the old ones stay.
void subdivide(double longest_edge, RigSkin& skin);

// The vertex halfway between two others, moved by both's bones.
std::uint32_t add_midpoint(std::uint32_t a, std::uint32_t b, RigSkin& skin);

}  // namespace graspdb
