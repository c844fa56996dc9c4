// SPDX-License-Identifier: MIT
#include "graspdb/pictures/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/crop.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/pictures/overlay.h"
#include "graspdb/tracker/estimate_json.h"
#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kHigh = 300;  // pixels, of the pictures above
constexpr int kRowSide = 180;
constexpr std::size_t kRowsShown = 5;
constexpr int kBetween = 12;
constexpr int kWords = 44;  // above a picture
const cv::Scalar kOutline = {90, 230, 90}, kArrow = {255, 160, 60};

using Colors = cv::Mat_<cv::Vec3b>;

Colors of_height(const cv::Mat& picture, int height) {
  const int width = static_cast<int>(std::lround(1.0 * picture.cols * height / picture.rows));
  Colors scaled;
  const int method = picture.rows < height ? cv::INTER_NEAREST : cv::INTER_AREA;
  cv::resize(picture, scaled, {std::max(1, width), height}, 0, 0, method);
  return scaled;
}

// The hand as it is, all else darker.
ColorImage with_hand(const ColorImage& frame, const Estimate& estimate) {
  ColorImage drawn = frame;
  cv::Mat pixels = as_mat(drawn);
  const cv::Mat hand = as_mat(estimate.hand);
  cv::Mat(pixels * 0.35).copyTo(pixels, hand == 0);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(hand.clone(), outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  const int thickness = std::max(1, frame.height() / 240);
  cv::drawContours(pixels, outlines, -1, kOutline, thickness, cv::LINE_AA);
  if (!estimate.towards_arm) return drawn;
  const Box& box = estimate.box;
  const cv::Point2d middle(box.x + box.width / 2.0, box.y + box.height / 2.0);
  const cv::Point2d arm = cv::Point2d(estimate.towards_arm->x(), estimate.towards_arm->y()) *
                          (0.7 * std::max(box.width, box.height));
  cv::arrowedLine(pixels, middle, middle + arm, kArrow, 2 * thickness, cv::LINE_AA, 0, 0.15);
  return drawn;
}

Colors described(const ColorImage& frame, const Estimate& estimate) {
  HandCrop crop;
  if (const auto square = crop_square(estimate.hand))
    crop = crop_hand(to_gray(frame), estimate.hand, *square);
  const cv::Mat gray(kCropSide, kCropSide, CV_8U, crop.gray.data());
  cv::Mat colors;
  cv::cvtColor(gray, colors, cv::COLOR_GRAY2BGR);
  return of_height(colors, kHigh);
}

std::string found_in_words(const Estimate& estimate) {
  if (estimate.box.width == 0) return "none";
  return estimate.towards_arm ? "the arrow points to its arm" : "no arm is seen";
}

std::string answer_in_words(const Estimate& estimate) {
  if (!estimate.valid) return why_no_answer(estimate);
  return fmt::format("{} hand, grasp {}, step {}, confidence {:.2f}",
                     estimate.left_hand ? "left" : "right", estimate.grasp, estimate.step,
                     estimate.confidence);
}

class Explanation {
 public:
  Explanation(const Database& database, EstimatePicture* rows) : database_(database), rows_(rows) {}

  ColorImage page(const ColorImage& frame, const Estimate& estimate) {
    add(of_height(as_mat(with_hand(frame, estimate)), kHigh), "1. the hand that was found",
        found_in_words(estimate));
    add(described(frame, estimate), "2. what is described",
        estimate.box.width > 0 ? fmt::format("the nearest row is {:.2f} away", estimate.distance)
                               : "nothing");
    add_rows(estimate);
    add(of_height(as_mat(with_skeleton(frame, estimate)), kHigh), "3. the answer",
        answer_in_words(estimate));
    return drawn();
  }

 private:
  struct Panel {
    Colors picture;
    std::string title, words;
  };

  void add(const Colors& picture, const std::string& title, const std::string& words) {
    panels_.push_back({picture, title, words});
  }

  void add_row(std::uint32_t row, bool left_hand, const std::string& words) {
    const Colors empty(kRowSide, kRowSide, cv::Vec3b(kPaper, kPaper, kPaper));
    const ColorImage drawn = rows_ ? rows_->draw_row(row, left_hand, kRowSide) : ColorImage();
    below_.push_back({rows_ ? Colors(as_mat(drawn)).clone() : empty,
                      fmt::format("grasp {} step {}", database_.grasp(row), database_.step(row)),
                      words});
  }

  void add_rows(const Estimate& estimate) {
    for (const Hypothesis& h : estimate.hypotheses) {
      if (below_.size() == kRowsShown) break;
      add_row(h.row, estimate.left_hand,
              fmt::format("row {}: {:.1f} %", h.row, 100 * h.weight) +
                  (h.roll_deg == 0 ? "" : fmt::format(", rolled {:g}", h.roll_deg)));
    }
    if (estimate.no_answer == NoAnswer::kUnlike)
      add_row(estimate.row, estimate.left_hand, fmt::format("row {}: too far away", estimate.row));
  }

  static int width_of(const std::vector<Panel>& panels) {
    int width = kBetween;
    for (const Panel& panel : panels) width += panel.picture.cols + kBetween;
    return width;
  }

  static void place(const std::vector<Panel>& panels, int y, Page& page) {
    int x = kBetween;
    for (const Panel& panel : panels) {
      page.write(panel.title, x, y + 16);
      page.write_small(panel.words, x, y + 34);
      page.place(panel.picture, x, y + kWords);
      x += panel.picture.cols + kBetween;
    }
  }

  ColorImage drawn() const {
    constexpr int kTitle = 24;
    const int above = kWords + kHigh + kBetween;
    const int below = below_.empty() ? 0 : kTitle + kWords + kRowSide + kBetween;
    Page page(std::max(width_of(panels_), width_of(below_)), above + below);
    place(panels_, 0, page);
    if (!below_.empty()) {
      page.write("the rows that were weighed, heaviest first", kBetween, above + 16);
      place(below_, above + kTitle, page);
    }
    return page.image();
  }

  const Database& database_;
  EstimatePicture* rows_;  // null: rows are not drawn
  std::vector<Panel> panels_, below_;
};

}  // namespace

ColorImage draw_explanation(const ColorImage& frame, const Estimate& estimate,
                            const Database& database, EstimatePicture* rows) {
  return Explanation(database, rows).page(frame, estimate);
}

}  // namespace graspdb
