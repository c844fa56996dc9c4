// SPDX-License-Identifier: MIT
#include "graspdb/generator/build_config.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/json/json_numbers.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/toml.h"
#include "graspdb/database/database.h"
#include "graspdb/grasps/grasp.h"
#include "jitter.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr Jitter kLargestJitter{.angles_deg = 30,
                                .wrist_deg = 30,
                                .object_size_percent = 30,
                                .visible_forearm_mm = 200,
                                .light_deg = 90,
                                .seed = std::numeric_limits<int>::max(),
                                .copies = 100};
const std::vector<std::string_view> kObjectsNames = {"held", "free", "both"};
const std::vector<std::string_view> kRendererNames = {"raster", "embree"};

void check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error({.key = name,
               .expected = fmt::format("{} to {}", low, high),
               .found = fmt::format("{}", value)});
}

// From the data directory when the file lies in it.
std::string portable(const fs::path& path) {
  const fs::path absolute = fs::weakly_canonical(path);
  const fs::path inside = absolute.lexically_relative(fs::weakly_canonical(data_directory()));
  const bool outside = inside.empty() || *inside.begin() == "..";
  return (outside ? absolute : inside).string();
}

// JSON as TOML: the two differ in how a table joins key and value.
std::string toml_value(const json& value) {
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const auto& [key, item] : value.items()) {
    if (!text.empty()) text += ", ";
    text += value.is_object() ? json(key).dump() + " = " + toml_value(item) : toml_value(item);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string toml_document(const json& root) {
  std::string text;
  for (const auto& [key, value] : root.items()) {
    text += json(key).dump() + " = " + toml_value(value) + "\n";
  }
  return text;
}

// The enumerator that `key` names, the first one if it is absent.
template <typename Enum>
Enum read_name(const TomlTable& table, const std::string& key,
               const std::vector<std::string_view>& names) {
  if (!table.has(key)) return Enum{};
  return static_cast<Enum>(std::ranges::find(names, table.choice(key, names)) - names.begin());
}

Light read_light(const TomlTable& table) {
  Light light;
  light.ambient = table.number_or("ambient", light.ambient, 0, 1);
  light.diffuse = table.number_or("diffuse", light.diffuse, 0, 1);
  if (table.has("towards_light_in_camera")) {
    light.towards_light_in_camera = table.vector3("towards_light_in_camera", -1e3, 1e3);
  }
  table.finish();
  return light;
}

Jitter read_jitter(const TomlTable& table) {
  const Jitter jitter{.angles_deg = table.number_or("angles_deg", 0, 0, kLargestJitter.angles_deg),
                      .wrist_deg = table.number_or("wrist_deg", 0, 0, kLargestJitter.wrist_deg),
                      .object_size_percent = table.number_or("object_size_percent", 0, 0,
                                                             kLargestJitter.object_size_percent),
                      .visible_forearm_mm = table.number_or("visible_forearm_mm", 0, 0,
                                                            kLargestJitter.visible_forearm_mm),
                      .light_deg = table.number_or("light_deg", 0, 0, kLargestJitter.light_deg),
                      .seed = table.integer_or("seed", 0, 0, kLargestJitter.seed),
                      .copies = table.integer_or("copies", 1, 1, kLargestJitter.copies)};
  table.finish();
  return jitter;
}

void check_jitter(const Jitter& jitter) {
  const Jitter& largest = kLargestJitter;
  check_range("jitter angles, degrees", jitter.angles_deg, 0, largest.angles_deg);
  check_range("jitter wrist, degrees", jitter.wrist_deg, 0, largest.wrist_deg);
  check_range("jitter object size, %", jitter.object_size_percent, 0, largest.object_size_percent);
  check_range("jitter forearm, mm", jitter.visible_forearm_mm, 0, largest.visible_forearm_mm);
  check_range("jitter light, degrees", jitter.light_deg, 0, largest.light_deg);
  check_range("jitter seed", jitter.seed, 0, largest.seed);
  check_range("jitter copies, which differ only by jitter", jitter.copies, 1,
              jitter.is_on() ? largest.copies : 1);
}

std::map<int, std::string> read_grasp_hashes(const TomlTable& table) {
  std::map<int, std::string> hashes;
  for (const std::string& key : table.keys()) {
    int id = 0;
    const auto [end, fault] = std::from_chars(key.data(), key.data() + key.size(), id);
    if (fault != std::errc() || end != key.data() + key.size()) {
      table.fail(key, "a grasp's number as its key", "\"" + key + "\"");
    }
    hashes[id] = table.string(key);
  }
  return hashes;
}

BuildConfig read_config(const TomlTable& table, const fs::path& beside) {
  BuildConfig config;
  if (table.has("hands")) {
    for (const auto& hand : table.strings("hands")) {
      config.hands.push_back(table.found("hands", hand, beside));
    }
  }
  config.grasps = table.found("grasps", table.string_or("grasps", "grasps"), beside);
  if (table.has("only")) config.only = table.integers("only", 1, kLargestGrasp);
  config.objects = read_name<Objects>(table, "objects", kObjectsNames);
  config.steps = table.integer_or("steps", config.steps, 1, 20);
  config.views = table.integer_or("views", config.views, 1, 100000);
  config.resolution = table.integer_or("resolution_px", config.resolution, 16, 1024);
  config.distance = table.number_or("distance_m", config.distance, 0.2, 5);
  config.visible_forearm = table.number_or("visible_forearm_m", config.visible_forearm, 0, 0.3);
  config.renderer = read_name<RowRenderer>(table, "renderer", kRendererNames);
  if (const auto light = table.table_if_any("light")) config.light = read_light(*light);
  if (const auto jitter = table.table_if_any("jitter")) config.jitter = read_jitter(*jitter);
  config.hog = hog_from_name(table.string_or("hog", hog_name(config.hog)), table.file());
  if (table.has("descriptor")) {
    config.descriptor = table.found("descriptor", table.string("descriptor"), beside);
  }
  config.descriptor_hash = table.string_or("descriptor_hash", "");
  if (table.has("hand_hashes")) config.hand_hashes = table.strings("hand_hashes");
  if (const auto hashes = table.table_if_any("grasp_hashes")) {
    config.grasp_hashes = read_grasp_hashes(*hashes);
  }
  table.finish();
  return config;
}

// A database stores every option: one that is gone was not left to its default.
void require_keys(const json& found, const json& expected, const std::string& name,
                  const std::string& file) {
  for (const auto& [key, value] : expected.items()) {
    if (!found.contains(key)) {
      throw Error({file, name + "." + key, "an option that every database has", "none"});
    }
    if (found[key].is_object()) require_keys(found[key], value, name + "." + key, file);
  }
}

// The JSON that a database stores, or that a file is; none for a TOML file.
std::optional<std::string> stored_json(const fs::path& path) {
  if (path.extension() == ".json") return read_text(path);
  // A TOML file has no zero bytes; the length before a database's header ends in some.
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> start{};
  const bool is_database = file.read(start.data(), start.size()) && start.back() == '\0';
  if (!is_database) return std::nullopt;
  return Database::open(path).info().config;
}

}  // namespace

bool Jitter::is_on() const {
  return angles_deg > 0 || wrist_deg > 0 || object_size_percent > 0 || visible_forearm_mm > 0 ||
         light_deg > 0;
}

std::string renderer_name(RowRenderer renderer) {
  return std::string(kRendererNames[static_cast<std::size_t>(renderer)]);
}

void check_config(const BuildConfig& config) {
  check_range("steps", config.steps, 1, 20);
  check_range("views", config.views, 1, 100000);
  check_range("resolution", config.resolution, 16, 1024);
  check_range("distance", config.distance, 0.2, 5);
  // From the palm's centre to the wrist and the camera's near side: it must not stand in the arm.
  constexpr double kClearance = 0.1;
  check_jitter(config.jitter);
  check_range(
      "visible forearm", config.visible_forearm, 0,
      std::min(0.3, config.distance - kClearance) - config.jitter.visible_forearm_mm / 1000);
}

std::string config_to_json(const BuildConfig& config) {
  json hands = json::array(), hashes = json::object();
  for (const fs::path& hand : config.hands) hands.push_back(portable(hand));
  for (const auto& [id, hash] : config.grasp_hashes) hashes[std::to_string(id)] = hash;
  json root{{"hands", std::move(hands)},
            {"grasps", portable(config.grasps)},
            {"only", config.only},
            {"objects", kObjectsNames[static_cast<std::size_t>(config.objects)]},
            {"steps", config.steps},
            {"views", config.views},
            {"resolution_px", config.resolution},
            {"distance_m", config.distance},
            {"visible_forearm_m", config.visible_forearm},
            {"renderer", renderer_name(config.renderer)},
            {"light",
             {{"ambient", config.light.ambient},
              {"diffuse", config.light.diffuse},
              {"towards_light_in_camera", numbers(config.light.towards_light_in_camera)}}},
            {"hog", hog_name(config.hog)},
            {"hand_hashes", config.hand_hashes},
            {"grasp_hashes", std::move(hashes)}};
  // Without it the text is that of databases from before there was any.
  if (config.jitter.is_on()) root["jitter"] = jitter_json(config.jitter);
  if (!config.descriptor.empty()) {
    root["descriptor"] = portable(config.descriptor);
    root["descriptor_hash"] = config.descriptor_hash;
  }
  return root.dump();
}

BuildConfig load_config(const fs::path& path) {
  const fs::path beside = fs::absolute(path).parent_path();
  const std::optional<std::string> stored = stored_json(path);
  if (!stored) return read_config(TomlTable::load(path), beside);
  const json root = parse_strict_json(*stored, path.string(), "config");
  if (!root.is_object()) {
    throw Error({path.string(), "config", "a JSON object of options", root.type_name()});
  }
  const std::string toml = toml_document(root);
  BuildConfig config = read_config(TomlTable::parse(toml, path.string()), beside);
  const BuildConfig whole{.jitter = {.light_deg = root.contains("jitter") ? 1.0 : 0.0}};
  require_keys(root, json::parse(config_to_json(whole)), "config", path.string());
  return config;
}

std::optional<BuildConfig> stored_config(const Database& database) {
  try {
    return load_config(database.path());
  } catch (const Error&) {
    return std::nullopt;
  }
}

fs::path preset_file(const std::string& name) {
  const fs::path folder = data_directory() / "assets/presets";
  std::set<std::string> known;
  std::error_code none;  // an absent folder has no presets
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".toml") known.insert(entry.path().stem().string());
  }
  if (known.contains(name)) return folder / (name + ".toml");
  throw Error({.file = folder.string(),
               .key = "preset",
               .expected = fmt::format("{}", fmt::join(known, ", ")),
               .found = name});
}

}  // namespace graspdb
