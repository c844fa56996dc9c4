// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "finder_net.h"
#include "frame_parts.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "wrist_colors.h"

namespace graspdb {
namespace {

// Of the picture that the net reads: it has learned from 160 x 120.
constexpr int kMostSeenPixels = 28'800;

int shrink_factor(const Box& window) {
  const double pixels = static_cast<double>(window.width) * window.height;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostSeenPixels))));
}

// Each pixel the mean of factor x factor, in whole numbers. What is left over at the right and
// below is not seen, unless nothing else is.
cv::Mat shrunk(const ColorImage& frame, const Box& window, int factor) {
  const cv::Mat part = as_mat(frame)(cv::Rect(window.x, window.y, window.width, window.height));
  const cv::Size size(std::max(1, window.width / factor), std::max(1, window.height / factor));
  const cv::Rect whole({0, 0}, cv::Size(std::min(window.width, size.width * factor),
                                        std::min(window.height, size.height * factor)));
  cv::Mat small;
  cv::resize(part(whole), small, size, 0, 0, cv::INTER_AREA);
  return small;
}

PaddedPicture first_picture(const cv::Mat& bgr, const Convolution& layer) {
  PaddedPicture picture(static_cast<std::size_t>(bgr.cols), static_cast<std::size_t>(bgr.rows),
                        layer.inputs, layer.padding);
  for (int y = 0; y < bgr.rows; ++y) {
    const std::uint8_t* from = bgr.ptr(y);
    std::uint8_t* to = picture.row(static_cast<std::size_t>(y));
    for (int x = 0; x < bgr.cols; ++x, from += 3, to += layer.inputs) std::copy_n(from, 3, to);
  }
  return picture;
}

// `coarse`, each pixel four times, and `fine` beside it.
PaddedPicture joined(const PaddedPicture& coarse, const PaddedPicture& fine, std::size_t padding) {
  const std::size_t channels = coarse.channels + fine.channels;
  PaddedPicture picture(fine.width, fine.height, channels, padding);
  for (std::size_t y = 0; y < fine.height; ++y) {
    const std::uint8_t *far = coarse.row(y / 2), *near = fine.row(y);
    std::uint8_t* to = picture.row(y);
    for (std::size_t x = 0; x < fine.width; ++x) {
      std::copy_n(far + x / 2 * coarse.channels, coarse.channels, to + x * channels);
      std::copy_n(near + x * fine.channels, fine.channels, to + x * channels + coarse.channels);
    }
  }
  return picture;
}

// One picture on its way through the net.
class Pass {
 public:
  Pass(const FinderNet& net, PaddedPicture picture) : net_(net), read_(std::move(picture)) {}

  // What the last layer reads.
  const PaddedPicture& run() {
    for (std::size_t i = 0; i + 1 < net_.layers.size(); ++i) {
      const FinderLayer& next = net_.layers[i + 1];
      const std::size_t padding = next.beside ? 0 : next.convolution.padding;
      results_.push_back(convolve(net_.layers[i].convolution, input(i), padding));
    }
    return input(net_.layers.size() - 1);
  }

 private:
  const PaddedPicture& input(std::size_t i) {
    const FinderLayer& layer = net_.layers[i];
    if (i > 0 && !layer.beside) return results_.back();
    if (layer.beside)
      read_ = joined(results_.back(), results_[*layer.beside], layer.convolution.padding);
    return read_;
  }

  const FinderNet& net_;
  PaddedPicture read_;
  std::vector<PaddedPicture> results_;  // of each layer
};

// How much a score is above the best of the others, as PartCells has it.
std::uint8_t lead(const std::int32_t* scores, FramePart part) {
  std::int32_t other = std::numeric_limits<std::int32_t>::min();
  for (std::size_t i = 0; i < kFramePartCount; ++i) {
    if (i != part) other = std::max(other, scores[i]);
  }
  return static_cast<std::uint8_t>(
      std::clamp(kLikeAnyOther + ((scores[part] - other) >> 1), 0, 255));
}

// Each cell's mean; what a cell lacks at the right and below is like its neighbours.
ColorImage cell_colors(const cv::Mat& seen, std::size_t cell, const cv::Size& cells) {
  const int side = static_cast<int>(cell);
  cv::Mat whole, colors;
  cv::copyMakeBorder(seen, whole, 0, cells.height * side - seen.rows, 0,
                     cells.width * side - seen.cols, cv::BORDER_REPLICATE);
  cv::resize(whole, colors, cells, 0, 0, cv::INTER_AREA);
  return to_color_image(colors);
}

FrameParts empty_parts(const Box& window, int cell_px, ColorImage colors) {
  const PartCells cells(colors.width(), colors.height());
  return {cells, cells, cells, std::move(colors), window, cell_px};
}

// So that a hand near the window's middle fills half of it: its fingers are seen best.
Box around(const Box& hand, const ColorImage& frame) {
  const int margin = std::max(hand.width, hand.height) / 3;
  const int left = std::max(hand.x - margin, 0), top = std::max(hand.y - margin, 0);
  return {left, top, std::min(hand.x + hand.width + margin, frame.width()) - left,
          std::min(hand.y + hand.height + margin, frame.height()) - top};
}

// Or comes so near to it that some of it may lie beyond.
bool reaches_edge(const Box& box, const Box& window) {
  const int x = window.width / 16, y = window.height / 16;
  return box.x < window.x + x || box.y < window.y + y ||
         box.x + box.width > window.x + window.width - x ||
         box.y + box.height > window.y + window.height - y;
}

FoundHand found_in(const FrameParts& parts, const ColorImage& frame) {
  return {painted(parts.hand, parts, frame.width(), frame.height()),
          painted(parts.arm, parts, frame.width(), frame.height())};
}

constexpr int kLeastCells = 12;  // fewer show no hand

std::optional<FrameParts> hand_in(const HandFinder& finder, const ColorImage& frame,
                                  const Box& window, const std::optional<Box>& roi) {
  FrameParts parts = finder.look(frame, window);
  weigh_colors(parts);
  return largest_hand(parts, kLeastCells, roi);
}

// At the same hand in another window; what was seen stays when it is not seen there.
void look_closer(const HandFinder& finder, const ColorImage& frame, const Box& window,
                 FrameParts& parts) {
  std::optional<FrameParts> closer = hand_in(finder, frame, window, hand_box(parts));
  if (closer) parts = std::move(*closer);
}

}  // namespace

std::filesystem::path finder_file(const std::string& name) {
  return data_directory() / "assets" / "finders" / (name + ".safetensors");
}

struct HandFinder::State {
  FinderNet net;
};

HandFinder::HandFinder(std::unique_ptr<State> state) : state_(std::move(state)) {}
HandFinder::~HandFinder() = default;
HandFinder::HandFinder(HandFinder&&) noexcept = default;
HandFinder& HandFinder::operator=(HandFinder&&) noexcept = default;

HandFinder HandFinder::load(const std::filesystem::path& file) {
  return HandFinder(std::make_unique<State>(State{load_finder_net(file)}));
}

HandFinder HandFinder::parse(std::string bytes, const std::string& name) {
  return HandFinder(std::make_unique<State>(State{parse_finder_net(std::move(bytes), name)}));
}

const std::string& HandFinder::hash() const {
  return state_->net.hash;
}

FrameParts HandFinder::look(const ColorImage& frame, const Box& window) const {
  GRASPDB_CHECK(window.width > 0 && window.height > 0 && window.x >= 0 && window.y >= 0 &&
                window.x + window.width <= frame.width() &&
                window.y + window.height <= frame.height());
  const FinderNet& net = state_->net;
  const Convolution& last = net.layers.back().convolution;
  const int factor = shrink_factor(window);
  const cv::Mat small = shrunk(frame, window, factor);
  Pass pass(net, first_picture(small, net.layers.front().convolution));
  const PaddedPicture& seen = pass.run();
  const cv::Size cells(static_cast<int>(last.out_size(seen.width)),
                       static_cast<int>(last.out_size(seen.height)));
  FrameParts parts =
      empty_parts(window, factor * static_cast<int>(net.cell), cell_colors(small, net.cell, cells));
  std::vector<std::int32_t> row(static_cast<std::size_t>(parts.hand.width()) * last.outputs);
  for (int y = 0; y < parts.hand.height(); ++y) {
    convolve_row(last, seen, static_cast<std::size_t>(y), row);
    for (int x = 0; x < parts.hand.width(); ++x) {
      const std::int32_t* scores = row.data() + static_cast<std::size_t>(x) * last.outputs;
      parts.hand.at(x, y) = lead(scores, kHand);
      parts.arm.at(x, y) = lead(scores, kArm);
      parts.object.at(x, y) = lead(scores, kObject);
    }
  }
  return parts;
}

std::optional<FoundHand> HandFinder::find(const ColorImage& frame,
                                          const std::optional<Box>& roi) const {
  GRASPDB_CHECK(!frame.empty());
  const Box whole{0, 0, frame.width(), frame.height()};
  std::optional<FrameParts> parts = hand_in(*this, frame, whole, roi);
  if (!parts) return std::nullopt;
  const Box near = around(hand_box(*parts), frame);
  if (shrink_factor(near) < shrink_factor(whole)) look_closer(*this, frame, near, *parts);
  return found_in(*parts, frame);
}

std::optional<FoundHand> HandFinder::find_again(const ColorImage& frame, const Box& last) const {
  GRASPDB_CHECK(last.x + last.width <= frame.width() && last.y + last.height <= frame.height());
  const Box window = around(last, frame);
  std::optional<FrameParts> parts = hand_in(*this, frame, window, last);
  if (!parts) return std::nullopt;
  const Box now = hand_box(*parts), next = around(now, frame);
  if (reaches_edge(now, window) && next != window) look_closer(*this, frame, next, *parts);
  return found_in(*parts, frame);
}

FoundHand find_hand(const ColorImage& frame, const std::optional<Box>& roi,
                    const FinderOptions& options) {
  if (!options.net) return find_by_color(frame, roi, options.skin);
  const Mask nothing(frame.width(), frame.height());
  return options.net->find(frame, roi).value_or(FoundHand{nothing, nothing});
}

}  // namespace graspdb
