// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "json_entry.h"

namespace graspdb {

constexpr std::size_t kLargestGlbJson = 16 << 20;   // bytes
constexpr std::size_t kLargestGltfJson = 64 << 20;  // with data in it

// The JSON of a glTF file of at most `largest` bytes. Throws Error for what is none, and for an
// extension that the file requires and that may change its shape.
nlohmann::json parsed_gltf(std::string_view text, const std::string& file, std::size_t largest);

// A mesh or a node whose shape keys are not at 0 shows another shape than that of its vertices.
void require_no_morph(const JsonEntry& entry);

}  // namespace graspdb
