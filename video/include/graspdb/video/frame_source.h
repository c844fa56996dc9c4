// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {

struct InputFrame {
  int index = 0;
  double time = 0;  // seconds
  ColorImage color;
  std::optional<Mask> mask;  // when the source brings one
};

// Frames one after the other, from a video, a folder of pictures (frame2 before frame10),
// "camera:0", or the folder of a rendered sequence (its noisy masks come along).
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::optional<InputFrame> next() = 0;  // none at the end
  virtual double frames_per_second() const = 0;
  // When it is known; a video's header may be wrong.
  virtual std::optional<std::size_t> count() const = 0;
  // Intrinsics and truth, when the source is a rendered sequence.
  virtual const WrittenSequence* sequence() const { return nullptr; }
};

inline constexpr std::string_view kCameraPrefix = "camera:";
// N of "camera:N"; none for all else.
std::optional<int> camera_number(const std::string& input);

// Whether it is the folder of a rendered sequence.
bool is_sequence(const std::filesystem::path& input);

// The mask of a picture: what is brighter than 127. Throws Error when it has another size.
Mask read_mask(const std::filesystem::path& file, const ColorImage& color);

// `masks` is a folder of masks named as the frames, or empty. Throws Error for what cannot be read.
std::unique_ptr<FrameSource> open_source(const std::string& input,
                                         const std::filesystem::path& masks);

}  // namespace graspdb
