// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {

// As a viewer or player shows it: upright, of square pixels.
struct InputFrame {
  int index = 0;
  double time = 0;   // seconds since the first: a video's own, a camera's clock, a folder's rate
  std::string file;  // its name when it is a picture, without its folder
  ColorImage color;
  std::optional<Mask> mask;        // when the source brings one
  std::vector<std::string> notes;  // what was done to it; of a video, with the first such frame
  double focal_px = 0;             // as a photograph's file states it; 0: it does not
};

// Frames one after the other, from a video, a picture, a folder of pictures (frame2 before
// frame10), "camera:0", or the folder of a rendered sequence (its noisy masks come along).
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::optional<InputFrame> next() = 0;  // none at the end
  virtual double frames_per_second() const = 0;
  // What was wrong with the source, such as a file that ends early; complete at the end.
  virtual std::vector<std::string> warnings() const { return {}; }
  // When it is known; a video's header may be wrong.
  virtual std::optional<std::size_t> count() const = 0;
  // Whether they are photographs that have nothing to do with each other: a single one, or a
  // folder of pictures whose names are not those of frames, which count up by one.
  virtual bool unrelated() const { return false; }
  // Intrinsics and truth, when the source is a rendered sequence.
  virtual const WrittenSequence* sequence() const { return nullptr; }
};

inline constexpr std::string_view kCameraPrefix = "camera:";
// N of "camera:N"; none for all else.
std::optional<int> camera_number(const std::string& input);

// Whether it is the folder of a rendered sequence.
bool is_sequence(const std::filesystem::path& input);

// The mask of a picture that is shown upright, of the same size: where it has the brighter of two
// levels of which one is 0 (0 and 1, 0 and 255 ...), or the label 1 beside 2, which is an object,
// as `graspdb export` writes them, or else is brighter than half. All 0 is no hand. Throws Error
// for another size and for levels of which none is clearly a hand's.
Mask read_mask(const std::filesystem::path& file, const ColorImage& color);

// `masks` is a folder of masks named as the frames, or empty; a camera's frames have none. Throws
// Error for what cannot be read.
std::unique_ptr<FrameSource> open_source(const std::string& input,
                                         const std::filesystem::path& masks);

}  // namespace graspdb
