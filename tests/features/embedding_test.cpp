// SPDX-License-Identifier: MIT
#include "graspdb/features/embedding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "features/net_bytes.h"
#include "features/net_fault.h"
#include "features/plain_layer.h"
#include "graspdb/core/error.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

using testing::Cube;
using testing::expect_refused;
using testing::NetFault;
using testing::NetFile;
using testing::NetLayer;
using testing::plain_layer;
using testing::small_net;

HandCrop random_crop(std::uint64_t seed) {
  RandomStream random(seed);
  HandCrop crop;
  for (CropPlane* plane : {&crop.gray, &crop.mask, &crop.scene}) {
    for (std::uint8_t& pixel : *plane) pixel = static_cast<std::uint8_t>(random.below(256));
  }
  return crop;
}

Embedding plain_code(const NetFile& file, const HandCrop& crop, double scale) {
  Cube cube{kCropSide, kCropSide, 2, {}};
  for (std::size_t i = 0; i < kCropPixels; ++i) {
    cube.values.insert(cube.values.end(), {crop.gray[i], crop.mask[i]});
  }
  for (const NetLayer& layer : file.layers) {
    cube = plain_layer(layer, cube, &layer == &file.layers.back());
  }
  double square = 0;
  for (const std::int64_t value : cube.values) square += static_cast<double>(value * value);
  Embedding code;
  for (const std::int64_t value : cube.values) {
    const double share = static_cast<double>(value) * scale / std::floor(std::sqrt(square));
    code.push_back(static_cast<std::uint8_t>(std::clamp(128 + std::round(share), 0.0, 255.0)));
  }
  return code;
}

class EachInstructionSet : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(EmbeddingNet, EachInstructionSet, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(EachInstructionSet, GivesTheCodeThatThePlainSumsGive) {
  use_param();
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const NetFile file = small_net(seed);
    const HandCrop crop = random_crop(seed);
    EXPECT_EQ(EmbeddingNet::parse(file.bytes(), "net").describe(crop), plain_code(file, crop, 500));
  }
  use_best();
}

TEST(EmbeddingNet, ABlackPictureHasACode) {
  NetFile file = small_net(1);
  for (NetLayer& layer : file.layers) std::ranges::fill(layer.bias, 0);
  const Embedding code = EmbeddingNet::parse(file.bytes(), "net").describe({});
  EXPECT_EQ(code, Embedding(64, 128));
}

TEST(EmbeddingNet, ItsHashIsThatOfItsBytes) {
  const std::string bytes = small_net(1).bytes();
  EXPECT_EQ(EmbeddingNet::parse(bytes, "a").hash(), EmbeddingNet::parse(bytes, "b").hash());
  EXPECT_NE(EmbeddingNet::parse(small_net(2).bytes(), "a").hash(),
            EmbeddingNet::parse(bytes, "a").hash());
}

class FaultyNet : public ::testing::TestWithParam<NetFault> {};

TEST_P(FaultyNet, IsRefusedByName) {
  expect_refused(GetParam(), small_net(4), EmbeddingNet::parse);
}

INSTANTIATE_TEST_SUITE_P(
    Each, FaultyNet,
    ::testing::Values(
        NetFault{"AnotherFormat", [](NetFile& f) { f.metadata["format"] = "other"; }, "format"},
        NetFault{"AnotherVersion", [](NetFile& f) { f.metadata["format_version"] = "1"; },
                 "format_version"},
        NetFault{"NoScale", [](NetFile& f) { f.metadata.erase("embedding_scale"); },
                 "embedding_scale"},
        NetFault{"AScaleOfText", [](NetFile& f) { f.metadata["embedding_scale"] = "\"9\""; },
                 "embedding_scale"},
        NetFault{"AnUnknownPlane", [](NetFile& f) { f.metadata["planes"] = R"(["gray","depth"])"; },
                 "depth"},
        NetFault{"MorePlanesThanInputs",
                 [](NetFile& f) { f.metadata["planes"] = R"(["gray","mask","scene"])"; },
                 "layer0.weight"},
        NetFault{"ALayerForOtherInputs", [](NetFile& f) { f.layers.erase(f.layers.begin() + 1); },
                 "layer1.weight"},
        NetFault{"AKernelLargerThanThePicture",
                 [](NetFile& f) { f.layers[2].padding = 0, f.layers[1].stride = 4; },
                 "layer2.weight"},
        NetFault{"MoreThanOnePixelAtTheEnd", [](NetFile& f) { f.layers[2].padding = 3; },
                 "one pixel"},
        NetFault{"SumsThatOverflow", [](NetFile& f) { f.layers[1].bias[3] = 2147483647; },
                 "layer1.bias"},
        NetFault{"ANegativeMultiplier", [](NetFile& f) { f.layers[1].multiplier[3] = -1; },
                 "layer1.multiplier"},
        NetFault{"ResultsWhoseSquaresOverflow",
                 [](NetFile& f) {
                   f.layers[2].bias[3] = 2000000000;
                   f.layers[2].multiplier[3] = 2147483647;
                 },
                 "layer2.multiplier"},
        NetFault{"NoStride", [](NetFile& f) { f.layers[0].stride = 0; }, "stride"}),
    [](const auto& fault) { return fault.param.name; });

TEST(EmbeddingNet, ATruncatedFileIsRefusedWhereverItEnds) {
  const std::string bytes = small_net(5).bytes();
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 7) {
    EXPECT_THROW(EmbeddingNet::parse(bytes.substr(0, size), "net"), Error);
  }
}

}  // namespace
}  // namespace graspdb
