// SPDX-License-Identifier: MIT
// eval: the files that plots and reports are made from.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "graspdb/core/file.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/sequences/sequence.h"
#include "program.h"
#include "support/replaced.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run_program;

using testing::kSource;
using testing::replaced;

// A tripod, closing, on the male hand, whose closed pose the project keeps; small and short, 14
// frames.
void write_short_sequence(const fs::path& folder, const std::string& name) {
  fs::create_directories(folder / "closed");
  for (const char* file : {"14_tripod.toml", "rest.toml", "closed/male.toml"})
    fs::copy_file(kSource / "grasps" / file, folder / file, fs::copy_options::skip_existing);
  write_text(folder / (name + ".seq.toml"), "name = \"" + name + R"("
seed = 1
visible_forearm_mm = 50
grasp = "14_tripod.toml"
grasp_type = 14
object_visible = false
[camera]
width_px = 320
height_px = 240
focal_px = 400
[look]
skin_bgr = [125, 155, 215]
object_bgr = [150, 90, 40]
towards_light = [0.3, -0.5, -1]
sensor_noise = 2
[hand]
file = "assets/hands/male.glb"
[[keyframe]]
time_s = 0
closure = 0
view_deg = [10, 0, 0]
palm_mm = [0, 0, 450]
[[keyframe]]
time_s = 1.3
closure = 1
view_deg = [30, 0, 0]
palm_mm = [10, 0, 450]
)");
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::istringstream text(line + ",");
  for (std::string cell; std::getline(text, cell, ',');) all.push_back(cell);
  return all;
}

// Lines as column to cell.
std::vector<std::map<std::string, std::string>> read_csv(const fs::path& file) {
  std::istringstream text(read_text(file));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = cells(line);
  std::vector<std::map<std::string, std::string>> lines;
  while (std::getline(text, line)) {
    const std::vector<std::string> values = cells(line);
    EXPECT_EQ(values.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i == 0) lines.emplace_back();
      lines.back()[names[i]] = values[i];
    }
  }
  return lines;
}

class Eval : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = std::make_unique<testing::TemporaryDirectory>();
    ASSERT_EQ(testing::build_tiny(*directory_ / "tiny.graspdb").code, 0);
    write_short_sequence(*directory_ / "set", "one");
    write_short_sequence(*directory_ / "set", "two");
    outcome_ = run_program("eval " + path("tiny.graspdb") + " --sequences " + path("set") +
                           " --alphas 0,2 --out " + path("out") + " --json");
    ASSERT_EQ(outcome_.code, 0) << outcome_.err;
  }
  static void TearDownTestSuite() { directory_.reset(); }
  static std::string path(const std::string& name) { return (*directory_ / name).string(); }

  static std::unique_ptr<testing::TemporaryDirectory> directory_;
  static Outcome outcome_;
};
std::unique_ptr<testing::TemporaryDirectory> Eval::directory_;
Outcome Eval::outcome_;

TEST_F(Eval, JsonHasTheKeysThatOthersRelyOn) {
  const json report = json::parse(outcome_.out);
  EXPECT_EQ(report, json::parse(read_text(path("out/eval.json"))));
  ASSERT_EQ(report["rows"].size(), 16U);  // 2 sequences x 4 models x 2 alphas
  for (const json& row : report["rows"]) {
    for (const char* key : {"sequence", "temporal", "alpha", "oracle", "random", "constant"})
      EXPECT_TRUE(row.contains(key)) << key;
    for (const json* errors : {&row, &row["oracle"], &row["random"], &row["constant"]}) {
      for (const char* key : {"pose_error", "joint_deg", "mpjpe_mm", "pa_mpjpe_mm", "flips"})
        EXPECT_TRUE((*errors)[key].is_number()) << key;
      EXPECT_TRUE((*errors)["rotation_deg"]["p90"].is_number());
      EXPECT_TRUE((*errors)["grasp_top1"].is_number());
    }
    EXPECT_GE(row["mpjpe_mm"], row["oracle"]["mpjpe_mm"]);
  }
  EXPECT_EQ(report["set"]["runs"].size(), 8U);
  EXPECT_EQ(report["set"]["differences"].size(), 12U);
  EXPECT_EQ(report["set"]["runs"][0]["means"]["pose_error"]["sequences"], 2);
  EXPECT_EQ(report["set"]["recovery"].size(), 4U);
  EXPECT_EQ(report["database"]["content_hash"].get<std::string>().size(), 32U);
}

TEST_F(Eval, FramesAreALineEachAndAddUpToTheRun) {
  const auto frames = read_csv(path("out/frames.csv")), runs = read_csv(path("out/runs.csv"));
  ASSERT_EQ(frames.size(), 16U * 14);
  ASSERT_EQ(runs.size(), 16U);
  double sum = 0;
  for (std::size_t i = 0; i < 14; ++i) {
    EXPECT_EQ(frames[i].at("sequence"), "\"one\"");
    EXPECT_EQ(frames[i].at("frame"), std::to_string(i));
    EXPECT_LE(std::stod(frames[i].at("oracle_pose_error")),
              std::stod(frames[i].at("pose_error")) + 0.2);
    EXPECT_EQ(frames[i].at("distance").empty(), frames[i].at("valid") == "0");
    sum += std::stod(frames[i].at("pose_error"));
  }
  EXPECT_NEAR(std::stod(runs[0].at("pose_error")), sum / 14, 1e-5);
  EXPECT_EQ(frames[0].at("grasp_top1"), "");  // not closed enough to ask for the type
  EXPECT_NE(frames[13].at("grasp_top1"), "");
}

TEST_F(Eval, TheTableNamesOracleRandomRowAndIntervals) {
  const Outcome table = run_program("eval " + path("tiny.graspdb") + " --sequences " +
                                    path("set/one.seq.toml") + " --alphas 0");
  EXPECT_EQ(table.code, 0);
  for (const char* text :
       {"one, rendered frames:", "object: ", "nearest in the database: ", "oracle", "random row",
        "best constant", "kde - none at 0 %", "gap to the oracle", "after 10 black frames", "95 %"})
    EXPECT_THAT(table.out, HasSubstr(text));
}

TEST_F(Eval, AnotherFrameRateShowsMoreFramesOfTheSameMotion) {
  const std::string one = path("set/one.seq.toml");
  const Outcome evaluated = run_program("eval " + path("tiny.graspdb") + " --sequences " + one +
                                        " --alphas 0 --fps 30 --json --out " + path("fast"));
  ASSERT_EQ(evaluated.code, 0) << evaluated.err;
  EXPECT_EQ(json::parse(evaluated.out)["fps"], 30);
  EXPECT_EQ(json::parse(outcome_.out)["fps"], nullptr);
  const auto fast = read_csv(path("fast/frames.csv")), slow = read_csv(path("out/frames.csv"));
  ASSERT_EQ(fast.size(), 4U * 40);  // 1.3 s, four models
  EXPECT_EQ(fast[39].at("time_s"), slow[13].at("time_s"));
  EXPECT_EQ(fast[39].at("closure"), slow[13].at("closure"));

  const Outcome rendered = run_program("sequence " + one + " --fps 20 --out " + path("frames"));
  EXPECT_THAT(rendered.out, HasSubstr("27 frames"));
  EXPECT_EQ(json::parse(read_text(path("frames/sequence.json")))["frames_per_second"], 20);
  for (const char* rate : {"0.5", "241", "nan"}) {
    const Outcome refused =
        run_program("sequence " + one + " --out " + path("no") + " --fps " + rate);
    EXPECT_EQ(refused.code, 2) << rate;
    EXPECT_THAT(refused.err, HasSubstr("--fps"));
  }
  EXPECT_FALSE(fs::exists(path("no")));
}

// JPEGs of the sequence's own frames.
void write_photographs(const fs::path& sequence, const fs::path& folder) {
  const SequenceRenderer renderer(load_sequence(sequence));
  fs::create_directories(folder);
  for (int i = 0; i < renderer.spec().frame_count(); ++i) {
    ColorImage color = renderer.render(i).color;
    cv::imwrite(folder / fmt::format("{:06}.jpg", i),
                cv::Mat(color.height(), color.width(), CV_8UC3, color.data()));
  }
}

TEST_F(Eval, PhotorealFramesAreEvaluatedAloneAndSaySo) {
  write_photographs(path("set/one.seq.toml"), path("photos/one"));
  const std::string eval = "eval " + path("tiny.graspdb") + " --sequences " + path("set") +
                           " --photoreal " + path("photos") + " --alphas 0 --out " +
                           path("photo-out");
  const Outcome table = run_program(eval);
  ASSERT_EQ(table.code, 0) << table.err;
  for (const char* text : {"one, photoreal frames:", "found hand against true hand",
                           "Means over 1 photoreal sequences"})
    EXPECT_THAT(table.out, HasSubstr(text));
  EXPECT_THAT(table.out, Not(HasSubstr("two")));
  const json report = json::parse(read_text(path("photo-out/eval.json")));
  EXPECT_EQ(report["kind"], "photoreal");
  ASSERT_EQ(report["rows"].size(), 4U);  // the models; the other sequence has no frames
  EXPECT_GT(report["rows"][0]["segmentation_iou"], 0.75);  // an arm within the frame is not cut
  EXPECT_EQ(report["rows"][0]["missed_hands"], 0);
  EXPECT_GT(report["rows"][0]["wrist_cut_mm"], 0);
  EXPECT_EQ(report["finder"]["name"], "hand");
  EXPECT_EQ(report["finder"]["weights"].get<std::string>().size(), 32U);  // their hash
  for (const char* file : {"photo-out/runs.csv", "photo-out/frames.csv"})
    EXPECT_EQ(read_csv(path(file))[0].at("kind"), "photoreal");
  EXPECT_GT(std::stod(read_csv(path("photo-out/runs.csv"))[0].at("segmentation_iou")), 0.75);

  const Outcome true_masks = run_program(eval + " --true-masks");
  ASSERT_EQ(true_masks.code, 0) << true_masks.err;
  EXPECT_THAT(true_masks.out, HasSubstr("one, photoreal-true-masks frames:"));
  EXPECT_THAT(true_masks.out, Not(HasSubstr("found hand against true hand")));

  EXPECT_EQ(json::parse(outcome_.out)["kind"], "rendered");
  EXPECT_EQ(read_csv(path("out/runs.csv"))[0].at("segmentation_iou"), "");
}

TEST_F(Eval, SamplesOfPhotorealFramesAreOfTheSequencesThatHaveThem) {
  write_photographs(path("set/one.seq.toml"), path("photos/one"));
  const Outcome samples = run_program("samples --sequences " + path("set") + " --photoreal " +
                                      path("photos") + " --out " + path("photos.safetensors"));
  ASSERT_EQ(samples.code, 0) << samples.err;
  EXPECT_THAT(samples.out, HasSubstr("frames of 1 sequences"));
  const Outcome none = run_program("samples --sequences " + path("set") + " --photoreal " +
                                   path("set") + " --out " + path("none.safetensors"));
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("name of a sequence"));
  EXPECT_FALSE(fs::exists(path("none.safetensors")));
}

TEST_F(Eval, AFolderWithTooFewPhotorealFramesIsRefusedBeforeAnythingIsRun) {
  fs::create_directories(path("few/one"));
  const std::string eval =
      "eval " + path("tiny.graspdb") + " --sequences " + path("set") + " --photoreal ";
  const Outcome few = run_program(eval + path("few"));
  EXPECT_EQ(few.code, 1);
  EXPECT_THAT(few.err, HasSubstr("14 pictures"));
  EXPECT_EQ(few.out, "");
  const Outcome none = run_program(eval + path("set"));
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("name of a sequence"));
}

TEST_F(Eval, TuneGivesWhatEvalGivesForTheSameOptions) {
  write_text(path("trackers.jsonl"), R"({"temporal": "none", "neighbours": 7})"
                                     "\n"
                                     R"({"temporal": "kde", "bandwidth": 0.3})"
                                     "\n");
  const std::string arguments =
      path("tiny.graspdb") + " --sequences " + path("set/one.seq.toml") + " --alphas 0";
  const Outcome tuned = run_program("tune " + arguments + " --trackers " + path("trackers.jsonl"));
  ASSERT_EQ(tuned.code, 0) << tuned.err;
  std::istringstream lines(tuned.out);
  for (const char* options : {" -k 7", " --bandwidth 0.3"}) {
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const json trial = json::parse(line);
    const json rows =
        json::parse(run_program("eval " + arguments + options + " --json").out)["rows"];
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const json& row) {
      return row["temporal"] == trial["temporal"];
    });
    EXPECT_EQ(trial["sequences"]["one"]["pose_error"], (*same)["pose_error"]);
  }
}

TEST_F(Eval, TuneRefusesAnOptionThatIsNone) {
  const std::string tune = "tune " + path("tiny.graspdb") + " --sequences " +
                           path("set/one.seq.toml") + " --trackers " + path("wrong.jsonl");
  for (const char* line : {R"({"temporal": "kde", "sigma": 1})", R"({"temporal": "hmm"})",
                           R"({"temporal": "kde", "kept": 0})",
                           R"({"temporal": "kde", "max_distance": 4})", "kde", ""}) {
    write_text(path("wrong.jsonl"), line);
    const Outcome refused = run_program(tune);
    EXPECT_EQ(refused.code, 1) << line;
    EXPECT_EQ(refused.out, "");
  }
}

TEST_F(Eval, AHandThatIsNotThereIsNamedBeforeAnythingIsRun) {
  write_short_sequence(*directory_ / "absent", "one");
  const fs::path file = path("absent/one.seq.toml");
  write_text(file, replaced(read_text(file), "male.glb", "none.glb"));
  const Outcome outcome =
      run_program("eval " + path("tiny.graspdb") + " --sequences " + path("absent"));
  EXPECT_EQ(outcome.code, 1);
  for (const char* told : {"one.seq.toml", "none.glb", "scripts/fetch_hands.sh"})
    EXPECT_THAT(outcome.err, HasSubstr(told));
}

TEST_F(Eval, AnotherHandAndItsGraspsTakeThePlaceOfASequencesOwn) {
  write_short_sequence(*directory_ / "strange", "strange");
  const fs::path file = path("strange/strange.seq.toml");
  const std::string text = read_text(file);
  write_text(file, replaced(text, "grasp_type = 14", "grasp_type = 9"));
  write_text(path("strange/untyped.seq.toml"),
             replaced(replaced(text, "grasp_type = 14\n", ""), "\"strange\"", "\"untyped\""));
  const std::string command = "eval " + path("tiny.graspdb") + " --sequences " + path("strange") +
                              " --alphas 0 --json --hand " +
                              (kSource / "assets/hands/female.glb").string() + " --grasps " +
                              (kSource / "grasps").string();
  const Outcome outcome = run_program(command);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("untyped is left out: no grasp of its type"));
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["rows"].size(), 4U);
  EXPECT_EQ(report["rows"][0]["sequence"], "strange");
  ASSERT_EQ(report["left_out"].size(), 1U);
  EXPECT_EQ(report["left_out"][0]["sequence"], "untyped");
  EXPECT_THAT(report["grasps"].get<std::string>(), HasSubstr("grasps"));
  EXPECT_THAT(report["hand"].get<std::string>(), HasSubstr("female.glb"));

  const json own = json::parse(run_program("eval " + path("tiny.graspdb") + " --sequences " +
                                           file.string() + " --alphas 0 --json")
                                   .out);
  EXPECT_EQ(own["left_out"].size(), 0U);
  for (const char* metric : {"joint_deg", "mpjpe_mm"})  // other angles, other lengths
    EXPECT_NE(own["rows"][0]["oracle"][metric], report["rows"][0]["oracle"][metric]);
}

TEST_F(Eval, AnotherHandThatEntersTheObjectLeavesOutThatSequence) {
  const Hand hand = load_hand(kSource / "assets/hands/male.glb");
  for (const char* name : {"fits", "clash"}) write_short_sequence(*directory_ / "clash", name);
  const fs::path file = path("clash/clash.seq.toml"), grasp_file = path("clash/clash.grasp.toml");
  write_text(file, replaced(read_text(file), "14_tripod.toml", "clash.grasp.toml"));
  write_text(grasp_file,
             replaced(read_text(path("clash/14_tripod.toml")), "number = 14", "number = 114"));
  const Grasp grasp = load_grasp(grasp_file);
  GraspPose inside = grasp.start;
  inside.hand_from_object.translation = {0, 0.05, 0};  // the middle of the palm
  keep_closed_poses({grasp}, hand, {inside});

  const std::string command =
      "eval " + path("tiny.graspdb") + " --alphas 0 --json --sequences " + path("clash");
  const Outcome refused = run_program(command);
  EXPECT_EQ(refused.code, 1);
  const std::string other = " --hand " + (kSource / "assets/hands/male.glb").string();
  const Outcome outcome = run_program(command + other);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("clash is left out: "));
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["rows"][0]["sequence"], "fits");
  EXPECT_EQ(report["left_out"][0]["sequence"], "clash");
  EXPECT_THAT(report["left_out"][0]["why"].get<std::string>(), HasSubstr("2 mm"));

  fs::remove(path("clash/fits.seq.toml"));
  const Outcome none = run_program(command + other);
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("every sequence is left out"));
  EXPECT_EQ(run_program(command + " --hand " + path("none.glb")).code, 1);
}

TEST_F(Eval, TwoSequencesOfOneNameAreRefused) {
  write_short_sequence(*directory_ / "twins", "one");
  fs::copy_file(path("twins/one.seq.toml"), path("twins/other.seq.toml"));
  const Outcome outcome =
      run_program("eval " + path("tiny.graspdb") + " --sequences " + path("twins"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("other.seq.toml"));
}

TEST_F(Eval, AnOutputThatIsNoFolderIsRefusedBeforeAnythingIsRun) {
  const Outcome outcome = run_program("eval " + path("tiny.graspdb") + " --sequences " +
                                      path("set") + " --out " + path("tiny.graspdb"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("tiny.graspdb"));
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace graspdb
