// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "checks.h"
#include "console.h"
#include "finder_options.h"
#include "frame_folder.h"
#include "graspdb/core/error.h"
#include "graspdb/features/hand_follower.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/finding.h"
#include "graspdb/tracker/hand_reader.h"
#include "graspdb/video/frame_source.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

namespace fs = std::filesystem;

struct FindArguments {
  std::string input, out, truth, database;
  FinderSettings finder;
  bool still = false;
};

// How found masks agree with true ones.
class Agreement {
 public:
  void add(const std::string& name, const Mask& found, const Mask& truth) {
    if (is_empty(truth)) {
      false_ += !is_empty(found);
      return;
    }
    missed_ += is_empty(found);
    const double iou = mask_iou(found, truth);
    sum_ += iou;
    ++count_;
    if (iou >= worst_) return;
    worst_ = iou;
    worst_name_ = name;
  }

  void print() const {
    if (count_ > 0) {
      fmt::print("intersection over union: mean {:.3f}, worst {:.3f} ({}), of {} hands\n",
                 sum_ / static_cast<double>(count_), worst_, worst_name_, count_);
    }
    fmt::print("hands that were not found: {}; found where there is none: {}\n", missed_, false_);
  }

 private:
  double sum_ = 0, worst_ = 2;
  std::string worst_name_;
  std::size_t count_ = 0, missed_ = 0, false_ = 0;
};

// Everything that one run of the verb keeps between frames.
class FindRun {
 public:
  explicit FindRun(const FindArguments& options)
      : options_(options),
        follower_(finder_options(), options.finder.box()),
        source_(open_source(options.input, options.truth)),
        folder_(options.out, "masks") {}

  void all_frames() {
    const Progress progress = console_progress("looked at", "frames");
    while (const auto frame = source_->next()) {
      one_frame(*frame);
      const std::size_t count = source_->count().value_or(0);
      progress(frames_, frames_ < count ? count : 0);  // it may have been too low
    }
    require_frames(*source_, options_.input, frames_);
    progress(frames_, frames_);
  }

  std::size_t finish() const {
    for (const std::string& warning : source_->warnings())
      fmt::print(stderr, "warning: {}\n", warning);
    fmt::print("{}: masks of {} frames, {} with a hand\n", options_.out, frames_, hands_);
    if (!options_.truth.empty()) agreement_.print();
    return hands_;
  }

 private:
  FinderOptions finder_options() {
    FinderOptions finder = options_.finder.options();
    if (options_.database.empty()) return finder;
    if (!finder.net)
      throw Error({.key = "--database",
                   .expected = "a learned finder beside it",
                   .found = options_.finder.finder});
    database_ = Database::open(options_.database);
    search_ = open_search(*database_, kDefaultSearch);
    finder.unlikeness = unlikeness_to(*database_, *search_, Handedness::kAuto);
    return finder;
  }

  void one_frame(const InputFrame& frame) {
    if (options_.still || source_->unrelated()) follower_.forget();
    const Mask hand = follower_.next(frame.color).hand;
    const fs::path file = folder_.file_of(frame);
    write_png(file, hand);
    ++frames_;
    hands_ += !is_empty(hand);
    if (!options_.truth.empty()) agreement_.add(file.filename().string(), hand, *frame.mask);
  }

  const FindArguments& options_;
  std::optional<Database> database_;
  std::unique_ptr<const Search> search_;
  HandFollower follower_;
  std::unique_ptr<FrameSource> source_;
  FrameFolder folder_;
  Agreement agreement_;
  std::size_t frames_ = 0, hands_ = 0;
};

std::string check_that_it_ends(const std::string& input) {
  return camera_number(input) ? "a camera's frames never end" : "";
}

// Masks of before are removed: they must not be what is read.
void check_apart(const FindArguments& options) {
  for (const std::string& read : {options.input, options.truth}) {
    std::error_code absent;
    if (fs::equivalent(read, options.out, absent))
      throw CLI::ValidationError("--out", read + " is read from");
  }
}

}  // namespace

void add_find(CLI::App& app) {
  auto options = std::make_shared<FindArguments>();
  CLI::App* verb = app.add_subcommand("find", "Find the hand in pictures or a video, as masks");
  verb->add_option("INPUT", options->input, "A video, a picture or a folder of pictures")
      ->required()
      ->check(check_that_it_ends);
  verb->add_option("--out", options->out,
                   "The folder for the masks, named as the pictures (000000.png ... for a video)")
      ->required()
      ->check(output_folder());
  verb->add_option("--truth", options->truth,
                   "A folder of true masks, named alike: tells how well the found ones agree");
  verb->add_option("--database", options->database,
                   "Where a learned finder's hand is near to no row of this database, it chooses "
                   "between that hand and the one of its colour, as `track` does");
  add_still_option(*verb, options->still);
  add_finder_option(*verb, options->finder);
  add_roi_option(*verb, options->finder);
  verb->footer(
      "`track --masks` takes such masks, mended by hand or not. The exit status is 3 when no "
      "frame\n"
      "had a hand.\n"
      "Example: graspdb find photographs --out masks");
  verb->callback([options] {
    check(options->finder);
    check_apart(*options);
    FindRun run(*options);
    run.all_frames();
    if (run.finish() == 0) throw CLI::RuntimeError(kNothingFound);
  });
}

}  // namespace graspdb::cli
