// SPDX-License-Identifier: MIT
// The configurations that have names.
#include <gmock/gmock.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/generator/build_config.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

BuildConfig paper() {
  BuildConfig config;
  config.hands = {data_directory() / "assets/hands/male.glb"};
  config.grasps = data_directory() / "grasps";
  return config;
}

TEST(Presets, PaperIsWhatABuildMakesWhenNothingIsAsked) {
  EXPECT_EQ(config_to_json(load_config(preset_file("paper"))), config_to_json(paper()));
}

TEST(Presets, TrackingAddsCodesEmptyHandsAndForearmsOfEveryLength) {
  BuildConfig config = paper();
  config.objects = Objects::kBoth;
  config.descriptor = data_directory() / "assets/descriptors/hand.safetensors";
  config.jitter = {.visible_forearm_mm = 185, .copies = 2};
  EXPECT_EQ(config_to_json(load_config(preset_file("tracking"))), config_to_json(config));
}

TEST(Presets, AnUnknownNameIsRefusedWithThoseThatThereAre) {
  try {
    preset_file("papers");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().found, "papers");
    EXPECT_THAT(error.fault().expected, HasSubstr("paper, tracking"));
  }
}

}  // namespace
}  // namespace graspdb
