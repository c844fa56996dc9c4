// SPDX-License-Identifier: MIT
// An object that scales with the hand, all the way to the rows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "small_build.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHand = GRASPDB_SOURCE_DIR "/assets/hands/child.glb";

// The descriptors of a build whose grasp 3 has a cylinder of this size, in a child's hand that
// closes as the committed pose says.
std::vector<std::uint8_t> descriptors(const fs::path& folder, const std::string& size) {
  const fs::path source = fs::path(GRASPDB_SOURCE_DIR) / "grasps";
  fs::create_directories(folder / "closed");
  std::string text = read_text(source / "03_medium_wrap.toml");
  const std::size_t begin = text.find("diameter_mm"), end = text.find('\n', text.find("length_mm"));
  write_text(folder / "wrap.toml", text.replace(begin, end - begin, size));
  fs::copy_file(source / "rest.toml", folder / "rest.toml");
  ClosedPoses closed = load_closed_poses(source / "closed/child.toml");
  closed.grasp_hashes[3] = grasp_hash(load_grasp(folder / "wrap.toml"));
  save_closed_poses(folder / "closed/child.toml", closed);

  BuildConfig config = testing::small_config();
  config.hands = {kHand};
  config.grasps = folder;
  config.only = {3};
  build_database(config, {.out = folder / "a.graspdb"});
  const Database database = Database::open(folder / "a.graspdb");
  std::vector<std::uint8_t> all;
  for (std::uint32_t row = 0; row < database.rows(); ++row) {
    const auto hog = database.hog(row);
    all.insert(all.end(), hog.begin(), hog.end());
  }
  return all;
}

double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int{a[i]} - int{b[i]});
  return sum / static_cast<double>(a.size());
}

TEST(ObjectSize, ThatScalesGivesTheRowsOfTheSizeThatItHasInTheHand) {
  const testing::TemporaryDirectory folder;
  const double share = hand_length(load_hand(kHand).skeleton) / kReferenceHandLength;
  const auto cylinder = [](double factor) {
    return fmt::format("diameter_mm = {:.6f}\nlength_mm = {:.6f}", 60 * factor, 150 * factor);
  };
  const auto large = descriptors(folder / "large", cylinder(1));
  const auto scaled = descriptors(folder / "scaled", cylinder(1) + "\nscales_with_hand = true");
  const auto small = descriptors(folder / "small", cylinder(share));
  EXPECT_LT(mean_difference(scaled, small), 0.01);
  EXPECT_GT(mean_difference(scaled, large), 1);
}

}  // namespace
}  // namespace graspdb
