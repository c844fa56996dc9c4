// SPDX-License-Identifier: MIT
#include "frame_folder.h"

#include <fmt/format.h>

#include <utility>

#include "graspdb/core/error.h"
#include "graspdb/core/folder.h"

namespace graspdb::cli {
namespace {

namespace fs = std::filesystem;

// As `track --masks` looks for them.
std::string picture_name(const InputFrame& frame) {
  const std::string name =
      frame.file.empty() ? fmt::format("{:06}", frame.index) : fs::path(frame.file).stem().string();
  return name + ".png";
}

}  // namespace

FrameFolder::FrameFolder(fs::path folder, const std::string& kind) : folder_(std::move(folder)) {
  renew_folder(folder_, {.kind = kind, .marker = ".graspdb-" + kind, .files = {"*.png"}});
}

fs::path FrameFolder::file_of(const InputFrame& frame) {
  const std::string name = picture_name(frame);
  if (!names_.insert(name).second)
    throw Error({folder_.string(), name, "pictures of different names", "two of this one"});
  return folder_ / name;
}

}  // namespace graspdb::cli
