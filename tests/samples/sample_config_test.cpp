// SPDX-License-Identifier: MIT
#include "graspdb/samples/sample_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

SampleConfig config_of(const std::string& text) {
  const TemporaryDirectory directory;
  write_text(directory / "samples.toml", text);
  return load_sample_config(directory / "samples.toml");
}

TEST(SampleConfig, AbsentKeysMeanTheirDefaults) {
  EXPECT_EQ(sample_config_json(config_of("")), sample_config_json({}));
}

// Another value within the key's range that goes with the defaults of all others.
nlohmann::json another(const nlohmann::json& value) {
  if (value.is_number_integer()) return value.get<int>() + 1;
  return value.get<double>() * 0.9 + 0.05;
}

TEST(SampleConfig, EveryNumberOfTheJsonIsReadBack) {
  const auto defaults = nlohmann::json::parse(sample_config_json({}));
  for (const auto& [key, value] : defaults.items()) {
    if (!value.is_number()) continue;
    const std::string text = key + " = " + another(value).dump();
    const auto read = nlohmann::json::parse(sample_config_json(config_of(text)));
    EXPECT_EQ(read[key], another(value)) << text;
  }
}

TEST(SampleConfig, WrongValuesAreRefusedByName) {
  for (const auto& [text, key] :
       std::vector<std::pair<std::string, std::string>>{{"held = 1.5", "held"},
                                                        {"noise_percent = -1", "noise_percent"},
                                                        {"noise_percent = nan", "noise_percent"},
                                                        {"views_per_pose = 0", "views_per_pose"},
                                                        {"leave_out = [1.5]", "leave_out"},
                                                        {"nearest_m = 2.0", "nearest_m"},
                                                        {"smallest_px = 300", "smallest_px"},
                                                        {"gestures = 0.9", "mixtures"},
                                                        {"unknown = 1", "unknown"}}) {
    try {
      config_of(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(key)) << text;
      EXPECT_THAT(error.what(), HasSubstr("samples.toml"));
    }
  }
}

TEST(SampleConfig, ItsHandsAreSeenFromTheFile) {
  const TemporaryDirectory directory;
  write_text(directory / "mine.glb", "");
  write_text(directory / "samples.toml", "hands = [\"mine.glb\", \"assets/hands/male.glb\"]");
  const SampleConfig config = load_sample_config(directory / "samples.toml");
  ASSERT_EQ(config.hands.size(), 2u);
  EXPECT_EQ(config.hands[0], directory / "mine.glb");
  EXPECT_EQ(config.hands[1], data_directory() / "assets/hands/male.glb");
}

}  // namespace
}  // namespace graspdb
