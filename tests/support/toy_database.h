// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "graspdb/core/random.h"
#include "graspdb/database/database.h"

namespace graspdb::testing {

// A stack of bones whose numbers are the same on every processor.
inline Skeleton stacked_skeleton() {
  Skeleton skeleton;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    skeleton.hand_from_bone_at_zero[bone].translation.y() = static_cast<double>(bone) / 64;
  }
  skeleton.tip_in_distal.fill({0, 1.0 / 64, 0});
  return skeleton;
}

// Two grasps, one hand, two variants, five steps, eight views.
inline DatabaseInfo toy_info() {
  return {.grasps = {{1, "Large Diameter"}, {9, "Palmar Pinch"}},
          .hands = {{"toy", stacked_skeleton()}},
          .variants = {"held", "free"},
          .steps = 5,
          .views = 8,
          .camera_distance = 0.75,
          .view_rule = "super-fibonacci",
          .hog = "paper",
          .config = R"({"resolution":128})",
          .tool = "graspdb test",
          .processor = ""};
}

// Row i is a pure function of i: labels are multiples of 1/256, descriptors are random bytes.
inline Row toy_row(std::size_t i) {
  RandomStream random(1, i);
  Row row;
  for (float& value : row.label) value = static_cast<float>(random.below(512)) / 256 - 1;
  for (std::uint8_t& value : row.hog) value = static_cast<std::uint8_t>(random.below(256));
  row.box = {-0.125F, -0.25F, 0.25F, 0.5F + static_cast<float>(i) / 256};
  row.view = static_cast<std::uint32_t>(i % 8);
  row.step = static_cast<std::uint8_t>(1 + i / 8 % 5);
  row.grasp = i / 40 % 2 == 0 ? 1 : 9;
  row.variant = static_cast<std::uint8_t>(i / 80 % 2);
  return row;
}

inline std::vector<Row> toy_rows(std::size_t count) {
  std::vector<Row> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i] = toy_row(i);
  return rows;
}

// The same with embeddings of so many bytes.
inline DatabaseInfo toy_info(std::size_t embedding_bytes) {
  DatabaseInfo info = toy_info();
  info.embedding_bytes = embedding_bytes;
  info.descriptor = "toy";
  info.weights = "0123456789abcdef0123456789abcdef";
  return info;
}

inline std::vector<Row> toy_rows(std::size_t count, std::size_t embedding_bytes) {
  std::vector<Row> rows = toy_rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(2, i);
    for (std::size_t k = 0; k < embedding_bytes; ++k) {
      rows[i].embedding.push_back(static_cast<std::uint8_t>(random.below(256)));
    }
  }
  return rows;
}

inline std::vector<DescriptorBytes> bytes_of(const std::vector<Descriptor>& descriptors) {
  std::vector<DescriptorBytes> all;
  for (const Descriptor& descriptor : descriptors) {
    all.emplace_back(descriptor.begin(), descriptor.end());
  }
  return all;
}

// Writes rows with these descriptors (for the tests of searching) and opens them.
inline Database database_of(const std::filesystem::path& path,
                            const std::vector<Descriptor>& descriptors) {
  std::vector<Row> rows = toy_rows(descriptors.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].hog = descriptors[i];
  write_database(path, toy_info(), rows);
  return Database::open(path);
}

}  // namespace graspdb::testing
