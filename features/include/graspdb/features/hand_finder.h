// SPDX-License-Identifier: MIT
// A learned finder: a small net in whole numbers that tells hand, arm and held object from the rest
// of a colour frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "graspdb/core/image.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {

// How much more a cell looks like a part than like any other: 128 and above, more.
using PartCells = Image<std::uint8_t>;

struct FrameParts {
  PartCells hand, arm, object;
  ColorImage color;  // of each cell, on average
  Box window;        // of the frame, from whose upper left corner cells are counted
  int cell_px = 1;   // width and height of a cell in the frame
};

// The file of a finder that has a name: assets/finders/NAME.safetensors in the data directory.
std::filesystem::path finder_file(const std::string& name);

// Immutable; thread-safe.
class HandFinder {
 public:
  // A file of weights (docs/finders.md). Throws Error naming file and key for one that is altered,
  // of another version or whose parts do not fit.
  static HandFinder load(const std::filesystem::path& file);
  // `name` stands for the file in messages.
  static HandFinder parse(std::string bytes, const std::string& name);
  ~HandFinder();
  HandFinder(HandFinder&&) noexcept;
  HandFinder& operator=(HandFinder&&) noexcept;

  const std::string& hash() const;  // of the file: tells which finder it was
  // What the pixels in a window show, which lies within the frame and is not empty; it is looked at
  // with no more than 28,800 pixels. The same bytes on every processor.
  FrameParts look(const ColorImage& frame, const Box& window) const;
  // The hand of which most is seen within `roi`, when given, else in the frame; none when no hand
  // is seen. Two looks at most: at the frame, and at the hand alone when that shows more of it.
  std::optional<FoundHand> find(const ColorImage& frame, const std::optional<Box>& roi = {}) const;
  // The hand of which most is seen where one was in the frame before, in a box within the frame:
  // looks around that box alone, and once more when the hand has moved on.
  std::optional<FoundHand> find_again(const ColorImage& frame, const Box& last) const;

 private:
  struct State;
  explicit HandFinder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// How unlike any hand what a mask shows in a frame is; 0: not at all. The mask is not empty.
using HandUnlikeness = std::function<double(const GrayImage& frame, const Mask& hand)>;

// How the hand is found in a frame.
struct FinderOptions {
  std::shared_ptr<const HandFinder> net;  // null: by the colour of skin
  SkinOptions skin;
  // By which HandFollower chooses between the net's hand and that of the colour of skin; null: the
  // net's.
  HandUnlikeness unlikeness = {};
};

// The hand in a frame, by the net or by find_by_color().
FoundHand find_hand(const ColorImage& frame, const std::optional<Box>& roi = {},
                    const FinderOptions& options = {});

}  // namespace graspdb
