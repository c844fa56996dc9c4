// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "graspdb/video/frame_source.h"

namespace graspdb::cli {

// A folder with a PNG per frame, named as the frames' own files are: 000000.png ... of a video.
class FrameFolder {
 public:
  // `kind` is a word for what is in it: "masks". An earlier result of that kind is removed. Throws
  // Error for a folder that holds anything else.
  FrameFolder(std::filesystem::path folder, const std::string& kind);

  // The file for this frame. Throws Error when another frame has had it.
  std::filesystem::path file_of(const InputFrame& frame);

 private:
  std::filesystem::path folder_;
  std::set<std::string> names_;
};

}  // namespace graspdb::cli
