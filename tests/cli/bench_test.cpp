// SPDX-License-Identifier: MIT
// bench of the tracker: what it tells of times and memory, and how it refuses.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "database/sealed_file.h"
#include "graspdb/core/file.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/tracker/tracker.h"
#include "program.h"
#include "support/replaced.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run_program;
using ::testing::SizeIs;

class Bench : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = std::make_unique<testing::TemporaryDirectory>();
    ASSERT_EQ(testing::build_tiny(*directory_ / "tiny.graspdb").code, 0);
    write_video("large", 640, 480);
    write_video("small", 320, 240);
  }
  static void TearDownTestSuite() { directory_.reset(); }

  // Two pictures of a wall.
  static void write_video(const std::string& name, int width, int height) {
    fs::create_directories(*directory_ / name);
    for (const char* file : {"0.png", "1.png"})
      write_png(*directory_ / name / file, ColorImage(width, height, {90, 90, 90}));
  }
  static std::string path(const std::string& name) { return (*directory_ / name).string(); }
  static Outcome run(const std::string& arguments) {
    return run_program("bench --queries 2 -k 2 " + path("tiny.graspdb") + " " + arguments);
  }
  static json tracker(const std::string& arguments) {
    return json::parse(run("--json " + arguments).out).at("tracker");
  }

  static std::unique_ptr<testing::TemporaryDirectory> directory_;
};
std::unique_ptr<testing::TemporaryDirectory> Bench::directory_;

TEST_F(Bench, EveryStageHasItsPercentilesAndTheyAddUp) {
  const json told = tracker("--frames 5 --video " + path("large"));  // more than there are
  EXPECT_EQ(told.at("frames"), 5);
  EXPECT_EQ(told.at("width_px"), 640);
  ASSERT_THAT(told.at("trackers"), SizeIs(3));
  for (const json& one : told.at("trackers")) {
    EXPECT_EQ(one.at("valid"), 0);
    for (const char* stage : {"segment", "describe", "search", "temporal", "total", "processor"}) {
      const json& ms = one.at("ms").at(stage);
      EXPECT_LE(ms.at("p50"), ms.at("p95")) << stage;
      EXPECT_LE(ms.at("p95"), ms.at("p99")) << stage;
    }
    EXPECT_GT(one.at("ms").at("segment").at("p50"), 0);
    EXPECT_GE(one.at("ms").at("total").at("p50"), one.at("ms").at("segment").at("p50"));
    EXPECT_EQ(one.at("ms").at("search").at("p99"), 0);  // a wall is not looked up
    EXPECT_GT(one.at("open_database_ms"), 0);
  }
}

TEST_F(Bench, FramesAreReadWithTheDefaultsOfTrack) {
  const TrackerOptions tuned = tuned_options(TemporalModel::kKde, DescriptorKind::kHog);
  const json bench = tracker("--frames 2 --video " + path("small"));
  for (const json& one : bench.at("trackers")) {
    EXPECT_EQ(one.at("temporal"), "kde");
    EXPECT_EQ(one.at("options").at("neighbours"), tuned.neighbors);
    EXPECT_EQ(one.at("options").at("sigma_hog"), tuned.sigma_hog);
    EXPECT_EQ(one.at("options").at("bandwidth"), tuned.bandwidth);
  }
}

TEST_F(Bench, MemoryIsWhatReadingAddsToWhatWasThere) {
#ifdef __SANITIZE_ADDRESS__
  constexpr double kLargest = 1000;  // the sanitizer keeps what is given back
#else
  constexpr double kLargest = 100;
#endif
  const json trackers = tracker("--frames 2 --video " + path("large")).at("trackers");
  for (const json& one : trackers) {
    EXPECT_GT(one.at("before_mb"), 1);
    EXPECT_GE(one.at("peak_mb"), 0);
    EXPECT_LT(one.at("peak_mb"), kLargest);
  }
}

TEST_F(Bench, TheTableTellsStagesMemoryAndRecall) {
  const Outcome table = run("--frames 2 --video " + path("large"));
  for (const char* text :
       {"p99", "temporal", "resident", "processor", "recall", "temporal model kde",
        "exact, ms per frame", "scan, ms per frame", "lsh, ms per frame"})
    EXPECT_THAT(table.out, HasSubstr(text));
}

TEST_F(Bench, ADatabaseThatTheTrackerRefusesIsNamed) {
  testing::FileParts parts = testing::take_apart(read_text(path("tiny.graspdb")));
  parts.header = testing::replaced(parts.header, R"("hog":"soft-edges")", R"("hog":"hard-edges")");
  write_text(path("foreign.graspdb"), testing::sealed(parts));
  const Outcome outcome = run_program("bench --queries 2 -k 2 --frames 2 --video " + path("small") +
                                      " " + path("foreign.graspdb"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(testing::lines_of(outcome.err), 1) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("foreign.graspdb"), HasSubstr("hard-edges")));
}

TEST_F(Bench, AVideoThatCannotBeReadIsNamed) {
  const Outcome outcome = run("--video " + path("none.mp4"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(testing::lines_of(outcome.err), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("none.mp4"));
}

}  // namespace
}  // namespace graspdb
