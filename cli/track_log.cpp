// SPDX-License-Identifier: MIT
#include "track_log.h"

#include <fmt/format.h>

#include <cstdio>

namespace graspdb::cli {

TrackLog::TrackLog(const std::string& json_file, const Database& database, bool live)
    : database_(database), live_(live), to_standard_output_(json_file == kStandardOutput) {
  if (!json_file.empty() && !to_standard_output_) json_.emplace(json_file);
}

void TrackLog::add(const InputFrame& frame, const Estimate& estimate, const Intrinsics& camera,
                   const std::string& camera_from) {
  Remarks remarks{.notes = frame.notes};
  if (estimate.colorless) {
    remarks.warnings.push_back(
        "the picture has no colour, by which hands are found: it needs a mask (--masks)");
  }
  for (const std::string& note : remarks.notes) tell(frame.index, note);
  for (const std::string& warning : remarks.warnings) tell(frame.index, "warning: " + warning);
  write_last();
  if (!json_ && !to_standard_output_) return;
  last_ = Line{
      {frame.index, frame.time, frame.file, camera, camera_from}, estimate, std::move(remarks)};
  if (live_) write_last();
}

void TrackLog::warn(const std::string& warning) {
  fmt::print(stderr, "warning: {}\n", warning);
  if (last_) last_->remarks.warnings.push_back(warning);
}

void TrackLog::commit() {
  write_last();
  if (json_) json_->commit();
}

// A folder of a thousand turned photographs says so once.
void TrackLog::tell(int frame, const std::string& remark) {
  if (told_.insert(remark).second) fmt::print(stderr, "frame {}: {}\n", frame, remark);
}

void TrackLog::write_last() {
  if (!last_) return;
  const std::string line =
      estimate_json(last_->frame, last_->estimate, database_, last_->remarks) + "\n";
  last_.reset();
  if (json_) json_->write(line);
  if (!to_standard_output_) return;
  fmt::print("{}", line);
  std::fflush(stdout);  // a program at the other end reads along
}

}  // namespace graspdb::cli
