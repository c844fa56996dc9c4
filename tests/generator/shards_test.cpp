// SPDX-License-Identifier: MIT
// Finished shards: what is kept, what is made again, what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "small_build.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::size_t kShardRows = 2 * 12;

// Builds from copies of the hand and of three grasps, which tests may change.
class Shards : public ::testing::Test {
 protected:
  Shards() {
    const fs::path source = GRASPDB_SOURCE_DIR;
    fs::create_directories(directory_ / "grasps/closed");
    for (const char* file : {"03_medium_wrap.toml", "09_palmar_pinch.toml",
                             "01_large_diameter.toml", "rest.toml", "closed/male.toml"}) {
      fs::copy_file(source / "grasps" / file, directory_ / "grasps" / file);
    }
    for (const char* file : {"male.glb", "male.rig.toml"}) {
      fs::copy_file(source / "assets/hands" / file, directory_ / file);
    }
    config_.hands = {directory_ / "male.glb"};
    config_.grasps = directory_ / "grasps";
  }

  BuildReport build() { return build_database(config_, job()); }
  BuildJob job() const { return {.out = directory_ / "a.graspdb", .work = directory_ / "work"}; }

  void append(const std::string& file, const std::string& text) {
    write_text(directory_ / file, read_text(directory_ / file) + text);
  }

  void replace(const std::string& file, const std::string& old_text, const std::string& new_text) {
    std::string text = read_text(directory_ / file);
    const std::size_t at = text.find(old_text);
    ASSERT_NE(at, std::string::npos) << old_text;
    write_text(directory_ / file, text.replace(at, old_text.size(), new_text));
  }

  std::vector<fs::path> files(const std::string& extension) const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(directory_.path())) {
      if (entry.path().extension() == extension) found.push_back(entry.path());
    }
    return found;
  }

  std::string refusal(const std::function<void()>& work) const {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  testing::TemporaryDirectory directory_;
  BuildConfig config_ = testing::small_config();
};

TEST_F(Shards, InPartsTheyGiveTheBytesOfOneBuild) {
  const BuildReport whole = build();
  EXPECT_EQ(whole.rendered_rows, 4 * kShardRows);
  for (const int parts : {1, 3, 33}) {
    const fs::path work = directory_ / std::to_string(parts), out = work / "out";
    for (int part = 0; part < parts; ++part) {
      const BuildJob job{.out = out, .work = work, .shard = part, .shards = parts};
      EXPECT_EQ(build_database(config_, job).content_hash.empty(), parts > 1);
    }
    EXPECT_EQ(merge_shards({.out = out, .work = work}).content_hash, whole.content_hash);
    EXPECT_EQ(read_text(out), read_text(directory_ / "a.graspdb"));
  }
}

TEST_F(Shards, AreUsedAgain) {
  const BuildReport first = build(), second = build();
  EXPECT_EQ(first.rendered_rows, 4 * kShardRows);
  EXPECT_EQ(second.rendered_rows, 0);
  EXPECT_EQ(second.rows, 4 * kShardRows);
  EXPECT_EQ(second.content_hash, first.content_hash);
}

TEST_F(Shards, ThatFollowAnAddedGraspAreAllThatIsRendered) {
  build();
  config_.only = {1, 3, 9};
  EXPECT_EQ(build().rendered_rows, 2 * kShardRows);
  EXPECT_EQ(build().rows, 6 * kShardRows);
}

TEST_F(Shards, OfAnAddedHandAreAllThatIsRendered) {
  build();
  config_.hands.insert(config_.hands.begin(),
                       fs::path(GRASPDB_SOURCE_DIR) / "assets/hands/child.glb");
  EXPECT_EQ(build().rendered_rows, 4 * kShardRows);
  EXPECT_EQ(Database::open(directory_ / "a.graspdb").hand(4 * kShardRows), 1);
}

TEST_F(Shards, OfAChangedGraspAreAllThatIsRendered) {
  build();
  append("grasps/09_palmar_pinch.toml", "# another word\n");
  EXPECT_EQ(build().rendered_rows, 2 * kShardRows);
}

TEST_F(Shards, AreMadeAgainForAnotherClosedPose) {
  config_.only = {1, 3};
  build();
  replace("grasps/closed/male.toml", "deviation = 0.0", "deviation = 1.0");  // of grasp 1
  EXPECT_EQ(build().rendered_rows, 2 * kShardRows);
}

TEST_F(Shards, AreMadeAgainForAnotherHandOrRigMap) {
  build();
  append("male.rig.toml", "# another word\n");
  EXPECT_EQ(build().rendered_rows, 4 * kShardRows);
  fs::copy_file(fs::path(GRASPDB_SOURCE_DIR) / "assets/hands/child.glb", directory_ / "male.glb",
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(build().rendered_rows, 4 * kShardRows);
}

TEST_F(Shards, AreMadeAgainForAnotherRestPose) {
  build();
  append("grasps/rest.toml", "# another word\n");
  EXPECT_EQ(build().rendered_rows, 0);
  replace("grasps/rest.toml", "flexion = ", "flexion = 1");
  EXPECT_EQ(build().rendered_rows, 4 * kShardRows);
}

TEST_F(Shards, AreMadeAgainForEveryOtherOption) {
  build();
  const auto rendered_with = [&](const auto& change) {
    const BuildConfig before = config_;
    change(config_);
    const BuildReport report = build();
    config_ = before;
    return report.rendered_rows == report.rows;
  };
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.resolution = 49; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.views = 11; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.steps = 1; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.distance = 0.71; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.visible_forearm = 0.016; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.light.ambient = 0.36; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.light.diffuse = 0.61; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.light.towards_light_in_camera.x() = 1; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.hog = HogMode::kPaper; }));
  EXPECT_TRUE(rendered_with([](BuildConfig& c) { c.renderer = RowRenderer::kEmbree; }));
  EXPECT_EQ(build().rendered_rows, 0);
}

TEST_F(Shards, ThatAreDamagedAreMadeAgain) {
  const BuildReport whole = build();
  const std::vector<fs::path> shards = files(".graspdb");
  ASSERT_EQ(shards.size(), 5u);  // and the database
  std::size_t damaged = 0;
  for (const fs::path& shard : shards) {
    if (shard.filename() == "a.graspdb") continue;
    std::string bytes = read_text(shard);
    bytes[bytes.size() - 1 - 100 * damaged++] ^= 1;
    write_text(shard, damaged == 4 ? bytes.substr(0, bytes.size() / 2) : bytes);
  }
  const BuildReport again = build();
  EXPECT_EQ(again.rendered_rows, 4 * kShardRows);
  EXPECT_EQ(again.content_hash, whole.content_hash);
}

TEST_F(Shards, ThatAreMissingAreNamed) {
  BuildJob part = job();
  part.shards = 2;
  build_database(config_, part);
  const std::string message = refusal([&] { merge_shards(job()); });
  EXPECT_THAT(message, HasSubstr("the shard male-held-009-"));
  EXPECT_FALSE(fs::exists(directory_ / "a.graspdb"));
}

TEST_F(Shards, MadeFromOtherFilesAreNamedAndNotMixedIn) {
  build();
  append("grasps/09_palmar_pinch.toml", "# another word\n");
  const std::string message = refusal([&] { merge_shards(job()); });
  EXPECT_THAT(message, HasSubstr("09_palmar_pinch.toml"));
}

TEST_F(Shards, OfABuildThatWasStoppedAreKept) {
  const std::string hash = build().content_hash;
  fs::remove_all(directory_ / "work");
  fs::remove(directory_ / "a.graspdb");
  BuildJob stopped = job();
  stopped.threads = 1;
  std::size_t asked = 0;
  stopped.stop = [&] { return ++asked > 2 * kShardRows; };
  const std::string message = refusal([&] { build_database(config_, stopped); });
  EXPECT_THAT(message, HasSubstr("interrupted"));
  EXPECT_THAT(message, HasSubstr("of 4 shards are finished"));
  EXPECT_FALSE(fs::exists(directory_ / "a.graspdb"));
  EXPECT_TRUE(files(".tmp").empty());
  const BuildReport resumed = build();
  EXPECT_LT(resumed.rendered_rows, 4 * kShardRows);
  EXPECT_EQ(resumed.content_hash, hash);
}

// A pose can have 100,000 views: 12 seconds.
TEST_F(Shards, AStopIsAskedForAtEveryRow) {
  BuildJob stopped = job();
  stopped.threads = 1;
  std::size_t asked = 0, done = 0;
  stopped.stop = [&] { return ++asked > kShardRows; };
  stopped.progress = [&](std::size_t rows, std::size_t) { done = rows; };
  refusal([&] { build_database(config_, stopped); });
  EXPECT_EQ(asked, kShardRows + 1);
  EXPECT_LT(done, kShardRows);
}

// A file that may not grow stands for a disk that is full.
TEST_F(Shards, OfABuildThatFoundTheDiskFullAreKeptAndNothingHalf) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, SIG_IGN);
  // More than a shard needs, less than the database.
  const rlimit small{.rlim_cur = 50000, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal([&] { build(); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_THAT(message, HasSubstr("cannot write"));
  EXPECT_FALSE(fs::exists(directory_ / "a.graspdb"));
  EXPECT_TRUE(files(".tmp").empty());
  EXPECT_EQ(build().rendered_rows, 0);
}

TEST_F(Shards, ADatabaseIsMadeAgainFromItsOwnConfiguration) {
  config_.hog = HogMode::kPaper;
  config_.visible_forearm = 0.03;
  config_.light.towards_light_in_camera = {0.1, -0.7, -1};
  const BuildReport first = build();
  const BuildJob again{.out = directory_ / "b.graspdb"};
  const BuildReport second = build_database(load_config(directory_ / "a.graspdb"), again);
  EXPECT_EQ(second.content_hash, first.content_hash);
  EXPECT_EQ(read_text(directory_ / "b.graspdb"), read_text(directory_ / "a.graspdb"));
}

TEST_F(Shards, AConfigurationRefusesFilesThatHaveChanged) {
  build();
  const BuildConfig stored = load_config(directory_ / "a.graspdb");
  append("male.rig.toml", "# another word\n");
  EXPECT_THAT(refusal([&] { build_database(stored, job()); }), HasSubstr("male.glb"));
}

TEST_F(Shards, TheConfigurationMayBeATextFile) {
  write_text(directory_ / "small.toml",
             "hands = [\"male.glb\"]\ngrasps = \"grasps\"\nonly = [3, 9]\nobjects = \"both\"\n"
             "steps = 2\nviews = 12\nresolution_px = 48\n");
  const BuildReport from_text =
      build_database(load_config(directory_ / "small.toml"), {.out = directory_ / "b.graspdb"});
  EXPECT_EQ(from_text.content_hash, build().content_hash);
  write_text(directory_ / "wrong.toml", "vews = 12\n");
  EXPECT_THAT(refusal([&] { load_config(directory_ / "wrong.toml"); }), HasSubstr("vews"));
  write_text(directory_ / "wrong.toml", "objects = \"some\"\n");
  EXPECT_THAT(refusal([&] { load_config(directory_ / "wrong.toml"); }), HasSubstr("objects"));
  write_text(directory_ / "wrong.toml", "renderer = \"blender\"\n");
  EXPECT_THAT(refusal([&] { load_config(directory_ / "wrong.toml"); }), HasSubstr("raster"));
}

TEST_F(Shards, AConfigurationMayHoldPathsOfAnyText) {
  const fs::path odd = directory_ / "q\"ü'\\ [x] = 1";
  fs::create_directory(odd);
  for (const char* file : {"male.glb", "male.rig.toml"})
    fs::copy_file(directory_ / file, odd / file);
  config_.hands = {odd / "male.glb"};
  config_.renderer = RowRenderer::kEmbree;
  write_text(directory_ / "odd.json", config_to_json(config_));
  const BuildConfig read = load_config(directory_ / "odd.json");
  EXPECT_EQ(read.hands, config_.hands);
  EXPECT_EQ(read.renderer, config_.renderer);
  EXPECT_EQ(config_to_json(read), config_to_json(config_));
}

TEST_F(Shards, AConfigurationThatIsNoneIsRefused) {
  const auto refusal_of = [&](const std::string& text) {
    write_text(directory_ / "wrong.json", text);
    return refusal([&] { load_config(directory_ / "wrong.json"); });
  };
  for (const char* text : {"null", "3", "[1]", "\"grasps\"", "{\"views\": }", ""}) {
    EXPECT_THAT(refusal_of(text), HasSubstr("wrong.json: 'config'")) << text;
  }
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_THAT(refusal_of("{\"only\": " + deep + "}"), HasSubstr("deeper"));
  EXPECT_THAT(refusal_of(R"({"grasp_hashes": {"3x": "0"}})"), HasSubstr("grasp_hashes.3x"));
  EXPECT_THAT(refusal_of(R"({"grasp_hashes": {"99999999999": "0"}})"), HasSubstr("99999999999"));
  EXPECT_THAT(refusal_of(R"({"only": [1.5]})"), HasSubstr("only"));
  EXPECT_THAT(refusal_of(R"({"steps\n": 5})"), HasSubstr("unknown key"));
}

TEST_F(Shards, AStoredConfigurationThatLacksAnOptionIsRefused) {
  const auto without = [&](const std::string& text) {
    std::string stored = config_to_json(config_);
    const std::size_t at = stored.find(text);
    EXPECT_NE(at, std::string::npos) << text;
    write_text(directory_ / "less.json", stored.erase(at, text.size()));
    return refusal([&] { load_config(directory_ / "less.json"); });
  };
  EXPECT_THAT(without("\"steps\":2,"), HasSubstr("less.json: 'config.steps'"));
  EXPECT_THAT(without(",\"views\":12"), HasSubstr("less.json: 'config.views'"));
  EXPECT_THAT(without("\"ambient\":0.35,"), HasSubstr("less.json: 'config.light.ambient'"));
  EXPECT_EQ(without(""), "no error");
}

TEST_F(Shards, OfTwoHandsWithOneNameAreRefused) {
  fs::create_directory(directory_ / "other");
  for (const char* file : {"male.glb", "male.rig.toml"}) {
    fs::copy_file(directory_ / file, directory_ / "other" / file);
  }
  config_.hands.push_back(directory_ / "other/male.glb");
  EXPECT_THAT(refusal([&] { build(); }), HasSubstr("male twice"));
}

TEST_F(Shards, OfAForearmThatReachesTheCameraAreRefused) {
  config_.distance = .2;
  config_.visible_forearm = .15;
  EXPECT_THAT(refusal([&] { build(); }), HasSubstr("visible forearm"));
}

// The hash that a build takes of its own source.
std::string hash_of(const fs::path& directory) {
  const std::string command = fmt::format(
      "cmake -DLIST={0}/list -DTEXT=versions -DOUT={0}/code.cpp -P {1}/cmake/hash_sources.cmake",
      directory.string(), GRASPDB_SOURCE_DIR);
  EXPECT_EQ(std::system(command.c_str()), 0);
  return read_text(directory / "code.cpp");
}

TEST(RowCode, AnotherByteOfItsSourceIsOtherCode) {
  const testing::TemporaryDirectory directory;
  write_text(directory / "render.cpp", "int a;");
  write_text(directory / "list", (directory / "render.cpp").string() + "\n");
  const std::string before = hash_of(directory.path());
  EXPECT_EQ(hash_of(directory.path()), before);
  write_text(directory / "render.cpp", "int b;");
  EXPECT_NE(hash_of(directory.path()), before);
}

}  // namespace
}  // namespace graspdb
