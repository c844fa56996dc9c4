// SPDX-License-Identifier: MIT
// All that the rows of a database depend on, as options and as text.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/database/database.h"
#include "graspdb/features/hog.h"
#include "graspdb/renderer/renderer.h"

namespace graspdb {

enum class Objects { kHeld, kFree, kBoth };

// Amplitudes of what is drawn evenly around what is stated (docs/jitter.md); 0 changes nothing. A
// row depends on the seed and not on what else is in the build.
struct Jitter {
  double angles_deg = 0;           // joint angles of the digits, within their ranges; 0..30
  double wrist_deg = 0;            // wrist flexion and deviation; 0..30
  double object_size_percent = 0;  // the hand is closed again on the object; 0..30
  double visible_forearm_mm = 0;   // 0..200
  double light_deg = 0;            // from the light's direction, another one each view; 0..90
  int seed = 0;                    // at least 0
  int copies = 1;                  // differently drawn ones, variants "held", "held 2"...; 1..100

  bool is_on() const;  // whether any amplitude is above 0
};

// Which of the renderer's two ways makes the pictures: rasterize() or render().
enum class RowRenderer { kRaster, kEmbree };

struct BuildConfig {
  std::vector<std::filesystem::path>
      hands;                     // .glb files, each with its rig map and a name of its own
  std::filesystem::path grasps;  // the folder of grasp files
  std::vector<int> only;         // grasp ids; empty = all
  Objects objects = Objects::kHeld;
  int steps = 5;                   // 1..20
  int views = 648;                 // 1..100000
  int resolution = 128;            // pixels a side, 16..1024
  double distance = 0.7;           // metres from camera to palm centre
  double visible_forearm = 0.015;  // metres beyond the wrist joint, at most distance - 0.1
  RowRenderer renderer = RowRenderer::kRaster;
  Light light;
  HogMode hog = HogMode::kSoftEdges;
  std::filesystem::path descriptor;  // a file of weights: rows have embeddings, too; may be empty
  Jitter jitter;

  // Of a configuration that was read from a database: what its files were. A build refuses files
  // that have changed. Empty: any will do.
  std::vector<std::string> hand_hashes;     // one a hand
  std::map<int, std::string> grasp_hashes;  // by grasp id
  std::string descriptor_hash;
};

// The name by which configurations know it.
std::string renderer_name(RowRenderer renderer);

// Throws Error naming the option that is out of range.
void check_config(const BuildConfig& config);

// The configuration as JSON, as a database stores it. Files inside data_directory() are named from
// there, so that the text means the same on another machine.
std::string config_to_json(const BuildConfig& config);

// A configuration from a database, a .json file (both hold the whole JSON above) or a TOML file
// with the same keys, where an absent one means its default. Throws Error naming file and key.
BuildConfig load_config(const std::filesystem::path& path);

// What an open database was built from; nothing when it holds no configuration of `graspdb build`.
std::optional<BuildConfig> stored_config(const Database& database);

// A configuration that has a name: assets/presets/NAME.toml in the data directory. "paper" is what
// BuildConfig{} is, "tracking" what the tracker works best with. Throws Error naming those that are
// there.
std::filesystem::path preset_file(const std::string& name);

}  // namespace graspdb
