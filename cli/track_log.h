// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>

#include "graspdb/core/file.h"
#include "graspdb/core/remarks.h"
#include "graspdb/database/database.h"
#include "graspdb/tracker/estimate_json.h"
#include "graspdb/tracker/tracker.h"
#include "graspdb/video/frame_source.h"

namespace graspdb::cli {

constexpr const char* kStandardOutput = "-";  // as the name of a file

// What `track` tells while it runs: a line of JSON a frame, when there is a file for it, and each
// remark once on the standard error. A line waits for the next frame, so that what is known only at
// the end comes with the last one; of a live source it does not, as somebody may wait for it.
class TrackLog {
 public:
  TrackLog(const std::string& json_file, const Database& database, bool live);

  void add(const InputFrame& frame, const Estimate& estimate, const Intrinsics& camera,
           const std::string& camera_from);
  void warn(const std::string& warning);  // of the whole run
  void commit();                          // the file appears

 private:
  struct Line {
    FrameName frame;
    Estimate estimate;
    Remarks remarks;
  };
  void tell(int frame, const std::string& remark);
  void write_last();

  const Database& database_;
  bool live_;
  bool to_standard_output_;
  std::optional<FileAside> json_;
  std::optional<Line> last_;
  std::set<std::string> told_;
};

}  // namespace graspdb::cli
