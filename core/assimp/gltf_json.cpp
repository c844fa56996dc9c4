// SPDX-License-Identifier: MIT
#include "gltf_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using nlohmann::json;

// What an extension that is none of these changes may be the shape.
void require_harmless_extensions(const JsonEntry& root) {
  constexpr std::array kHarmless = {"KHR_materials_", "KHR_texture_",  "KHR_lights_",
                                    "KHR_xmp",        "EXT_texture_",  "EXT_lights_",
                                    "MSFT_texture_",  "KHR_animation_"};
  for (const JsonEntry& entry : root.items("extensionsRequired")) {
    const std::string name = entry.text();
    const auto begins = [&](const char* start) { return name.starts_with(start); };
    if (name == "KHR_mesh_quantization" || std::ranges::any_of(kHarmless, begins)) continue;
    entry.refuse("no extension that the shape depends on, besides KHR_mesh_quantization",
                 name + " (save the file again without it, for example uncompressed)");
  }
}

json json_of(std::string_view text, const std::string& file, std::size_t largest) {
  if (text.size() > largest) {
    throw Error({file, "JSON", fmt::format("at most {} MiB", largest >> 20),
                 fmt::format("{} bytes", text.size())});
  }
  try {
    // Some writers pad with zeros where the specification says spaces.
    return json::parse(text.substr(0, text.find_last_not_of('\0') + 1));
  } catch (const json::exception& fault) {
    throw Error({file, "JSON", "JSON", fault.what()});
  }
}

}  // namespace

json parsed_gltf(std::string_view text, const std::string& file, std::size_t largest) {
  json root = json_of(text, file, largest);
  require_harmless_extensions(JsonEntry(root, file));
  return root;
}

void require_no_morph(const JsonEntry& entry) {
  const std::vector<JsonEntry> weights = entry.items("weights");
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!weights[i].is_zero())
      weights[i].refuse("0: a shape key is to be applied before the export");
  }
}

}  // namespace graspdb
