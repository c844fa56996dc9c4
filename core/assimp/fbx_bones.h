// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graspdb {

// Throws Error that names `file` when two nodes of an .fbx, text or binary, have one name and one
// of them is a bone. assimp gives the second one another name without a word, and frees the bone
// twice.
void require_own_bone_names(std::string_view bytes, const std::string& file);

}  // namespace graspdb
