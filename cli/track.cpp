// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <opencv2/highgui.hpp>

#include "checks.h"
#include "console.h"
#include "finder_options.h"
#include "frame_folder.h"
#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/evaluation/evaluate.h"
#include "graspdb/evaluation/tables.h"
#include "graspdb/generator/build_config.h"
#include "graspdb/pictures/estimate_picture.h"
#include "graspdb/pictures/explanation.h"
#include "graspdb/pictures/overlay.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/tracker/hand_reader.h"
#include "graspdb/video/frame_source.h"
#include "graspdb/video/video_writer.h"
#include "track_camera.h"
#include "track_log.h"
#include "track_statistics.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

constexpr int kOverlayHeight = 360;

struct TrackArguments {
  std::string database, input, masks, json, video, explain;
  Handedness handedness = Handedness::kAuto;
  TrackerSettings tracker;
  CameraSettings camera;
  FinderSettings finder;
  bool show = false, still = false;
};

// Of rendered sequences, whose truth is a right hand's, nothing is left open.
Handedness handedness_of(const TrackArguments& options, const FrameSource& source) {
  const bool known = source.sequence() && options.handedness == Handedness::kAuto;
  return known ? Handedness::kRight : options.handedness;
}

ReaderOptions reader_options(const TrackArguments& options, const Database& database,
                             const FrameSource& source) {
  return {.tracker = options.tracker.options(database),
          .finder = options.finder.options(options.masks.empty()),
          .roi = options.finder.box(),
          .handedness = handedness_of(options, source),
          .still = options.still || source.unrelated()};
}

// What `build --preset tracking` has and this database has not.
void tell_what_is_lacking(const Database& database) {
  const std::optional<BuildConfig> config = stored_config(database);
  if (!config) return;
  const bool has_free = config->objects != Objects::kHeld;
  const bool has_forearms = config->jitter.visible_forearm_mm > 0;
  if (!has_free)
    fmt::print(stderr, "the database has no hands without objects: empty hands are read badly\n");
  if (!has_forearms) {
    fmt::print(stderr,
               "the database has one length of forearm: hands with sleeves or long arms are read "
               "badly\n");
  }
  if (!database.has_embeddings()) {
    fmt::print(stderr,
               "the database has no codes of a learned descriptor: all hands are read badly\n");
  }
  if (!has_free || !has_forearms || !database.has_embeddings())
    fmt::print(stderr, "`graspdb build --preset tracking` makes one for tracking\n");
}

// Everything that one run of the verb keeps between frames.
class Run {
 public:
  explicit Run(const TrackArguments& options)
      : options_(options),
        source_(open_source(options.input, options.masks)),
        database_(Database::open(options.database)),
        reader_(database_, reader_options(options, database_, *source_), options.tracker.search),
        log_(options.json, database_, camera_number(options.input).has_value()),
        camera_(options.camera) {
    tell_what_is_lacking(database_);
    if (source_->unrelated() && !options.still)
      fmt::print(stderr, "photographs: each is read by itself, as --still has it\n");
    if (!options.video.empty()) video_.emplace(options.video, source_->frames_per_second());
    if (!options.explain.empty()) explained_.emplace(options.explain, "explanations");
    if (video_ || options.show || explained_) answer_.emplace(database_);
  }

  void all_frames() {
    const Progress progress = console_progress("tracked", "frames");
    std::size_t done = 0;
    while (const auto frame = source_->next()) {
      one_frame(*frame);
      ++done;
      const std::size_t count = source_->count().value_or(0);
      progress(done, done < count ? count : 0);  // it may have been too low
      if (stop_ || interrupted()) break;
    }
    require_frames(*source_, options_.input, done);
    progress(done, done);
    for (const std::string& warning : source_->warnings()) log_.warn(warning);
    if (camera_.distorted()) log_.warn("the camera's lens bends lines, which is not undone");
    if (!any_hand()) {
      log_.warn(fmt::format("no hand in any of {} frames ({} show something that resembles no row)",
                            done, statistics_.seen));
    }
  }

  bool any_hand() const { return statistics_.valid > 0; }

  void finish() {
    log_.commit();
    if (video_) video_->finish();
    // Answers on standard output stand there alone.
    std::FILE* const to = options_.json == kStandardOutput ? stderr : stdout;
    print(statistics_, to);
    if (source_->sequence()) print_against_truth(to);
  }

 private:
  Intrinsics camera_of(const InputFrame& frame) {
    const Intrinsics camera = camera_.of(frame, source_->sequence());
    if (camera_.origin() == "guess" && !guess_told_) {
      fmt::print(stderr, "no --focal: {:.0f} px is taken, a guess; distances scale with it\n",
                 camera.fx);
      guess_told_ = true;
    }
    return camera;
  }

  void one_frame(const InputFrame& frame) {
    const Intrinsics camera = camera_of(frame);
    const Estimate estimate = frame.mask ? reader_.read(frame.color, *frame.mask, camera)
                                         : reader_.read(frame.color, camera);
    statistics_.add(estimate);
    log_.add(frame, estimate, camera, camera_.origin());
    if (video_ || options_.show) draw(frame, estimate);
    if (explained_) explain(frame, estimate);
    if (source_->sequence()) compare_with_truth(frame, estimate);
  }

  void draw(const InputFrame& frame, const Estimate& estimate) {
    const std::optional<ColorImage> answer = picture_of(estimate);
    const std::string caption =
        estimate.valid ? fmt::format("{}  grasp {} step {}  confidence {:.2f}", frame.index,
                                     estimate.grasp, estimate.step, estimate.confidence)
                       : fmt::format("{}  no hand: {}", frame.index, why_no_answer(estimate));
    const ColorImage overlay =
        draw_overlay({frame.color, estimate, answer, caption}, kOverlayHeight);
    if (video_) video_->write(overlay);
    if (options_.show) show(overlay);
  }

  // The hand and grasp files may be gone: then the panel stays empty, and that is told once.
  std::optional<ColorImage> picture_of(const Estimate& estimate) {
    if (!estimate.valid || !answer_) return std::nullopt;
    try {
      return answer_->draw(estimate, kOverlayHeight);
    } catch (const Error& error) {
      draw_no_rows(error);
      return std::nullopt;
    }
  }

  void draw_no_rows(const Error& why) {
    fmt::print(stderr, "answers are not drawn: {}\n", why.what());
    answer_.reset();
  }

  ColorImage explanation_of(const InputFrame& frame, const Estimate& estimate) {
    try {
      return draw_explanation(frame.color, estimate, database_, answer_ ? &*answer_ : nullptr);
    } catch (const Error& error) {
      draw_no_rows(error);
      return draw_explanation(frame.color, estimate, database_, nullptr);
    }
  }

  void explain(const InputFrame& frame, const Estimate& estimate) {
    write_png(explained_->file_of(frame), explanation_of(frame, estimate));
  }

  void show(const ColorImage& overlay) {
    cv::imshow("graspdb", as_mat(overlay));
    const int key = cv::waitKey(1);
    stop_ = key == 'q' || key == 27;
  }

  void compare_with_truth(const InputFrame& frame, const Estimate& estimate) {
    const auto& truth = source_->sequence()->truth;
    const auto i = static_cast<std::size_t>(frame.index);
    if (!estimate.valid || i >= truth.size()) return;
    errors_.push_back(compare(answer_of(estimate, database_), target_of(truth[i])));
  }

  // A written sequence does not say what type its grasp is.
  Target target_of(const FrameTruth& truth) const {
    return graspdb::target_of(truth, source_->sequence()->camera, std::nullopt);
  }

  void print_against_truth(std::FILE* to) const {
    std::vector<Target> targets;
    for (const FrameTruth& truth : source_->sequence()->truth) targets.push_back(target_of(truth));
    const Baselines base = baselines(PoseGrid(database_), targets, 0);
    fmt::print(to, "{}", error_table({{options_.tracker.temporal, summarize(errors_)}}, base));
  }

  const TrackArguments& options_;
  std::unique_ptr<FrameSource> source_;
  Database database_;
  HandReader reader_;
  TrackLog log_;
  std::optional<VideoWriter> video_;
  std::optional<EstimatePicture> answer_;
  std::optional<FrameFolder> explained_;
  TrackCamera camera_;
  bool guess_told_ = false;
  TrackStatistics statistics_;
  std::vector<FrameErrors> errors_;
  bool stop_ = false;
};

// A check of CLI11: an empty answer says that all is well.
std::string check_input(const std::string& input) {
  const bool well = !input.starts_with(kCameraPrefix) || camera_number(input);
  return well ? "" : fmt::format("{}: a camera is camera:N, N = 0, 1 ...", input);
}

void check_together(const TrackArguments& options) {
  check(options.finder);
  if (!options.masks.empty() && camera_number(options.input))
    throw CLI::ValidationError("--masks", "a camera's frames have none");
  const CameraSettings& camera = options.camera;
  if (is_sequence(options.input) &&
      (camera.focal_px > 0 || !camera.principal_px.empty() || !camera.file.empty()))
    throw CLI::ValidationError("--focal, --principal, --camera",
                               "a rendered sequence states its own camera");
}

}  // namespace

void add_track(CLI::App& app) {
  auto options = std::make_shared<TrackArguments>();
  CLI::App* verb = app.add_subcommand("track", "Read a hand's pose from video");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option(
          "INPUT", options->input,
          "A video, a picture, a folder of pictures, camera:N, or the folder of a rendered "
          "sequence")
      ->required()
      ->check(check_input);
  verb->add_option(
      "--masks", options->masks,
      "A folder of hand masks, named as the frames [skin segmentation; a sequence's noisy/]");
  add_tracker_options(*verb, options->tracker);
  add_camera_options(*verb, options->camera);
  add_still_option(*verb, options->still);
  add_finder_option(*verb, options->finder);
  add_roi_option(*verb, options->finder);
  verb->add_option("--handedness", options->handedness,
                   "The hand that is seen; auto: as the frames tell")
      ->transform(named<Handedness>({{"auto", Handedness::kAuto},
                                     {"right", Handedness::kRight},
                                     {"left", Handedness::kLeft}}))
      ->default_str("auto");
  verb->add_option("--json", options->json,
                   "Write one JSON object per frame to this file; -: to standard output")
      ->check(output_file_or_dash());
  verb->add_option("--video", options->video,
                   "Write frame, mask, HOG and estimate side by side to this .mp4")
      ->check(output_file({".mp4"}));
  verb->add_option("--explain", options->explain,
                   "Write the steps from each frame to its answer as pictures in this folder")
      ->check(output_folder());
  verb->add_flag("--show", options->show, "Show the same in a window; q ends");
  verb->footer(
      "The exit status is 3 when no frame had a hand.\n"
      "Example: graspdb track hands.graspdb video.mp4 --focal 900 --video overlay.mp4");
  verb->callback([options] {
    check_together(*options);
    stop_on_interrupt();
    Run run(*options);
    run.all_frames();
    run.finish();
    if (!run.any_hand()) throw CLI::RuntimeError(kNothingFound);
  });
}

}  // namespace graspdb::cli
