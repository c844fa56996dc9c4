// SPDX-License-Identifier: MIT
// Square pictures of a posed hand with or without an object, and pages of them, for people to look
// at.
#pragma once

#include <Eigen/Core>
#include <bitset>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// A way to look at a hand.
struct Side {
  const char* name;
  Eigen::Vector3d looking;  // hand frame
  Eigen::Vector3d up;
};

namespace sides {
inline const Side kPalm = {"palm", {0, 0.1, 1}, {0, 1, 0}};
inline const Side kBack = {"back", {0, 0, -1}, {0, 1, 0}};
inline const Side kThumb = {"thumb side", {1, 0, 0.15}, {0, 1, 0}};
inline const Side kLittleFinger = {"little finger side", {-1, 0, 0.2}, {0, 1, 0}};
inline const Side kFingerTips = {"finger tips", {0, -1, 0.25}, {0, 0, 1}};
inline const Side kThumbAndPalm = {"between thumb and palm", {0.75, -0.25, 0.75}, {0, 1, 0}};
}  // namespace sides

// What a picture must hold: points of the hand frame, metres.
using Framed = std::vector<Eigen::Vector3f>;

using BoneSet = std::bitset<kBoneCount>;

// A view in the colours of skin and object, on paper unless told. The skin of `marked` bones has
// another colour; it needs the layer of parts.
constexpr std::uint8_t kPaper = 250;
ColorImage colored(const View& view, const BoneSet& marked = {}, std::uint8_t background = kPaper);

class ModelView {
 public:
  // `object` may be null.
  ModelView(const Hand& hand, const GraspPose& pose, const Solid* object);

  // The hand with the part of the forearm that pictures show.
  const Framed& framed() const { return framed_; }

  // A square of `pixels` that `framed` fills: the model's own, or one shared by pictures that are
  // to be compared. The skin of `marked` bones has another colour.
  cv::Mat_<cv::Vec3b> seen(const Side& side, int pixels) const;
  cv::Mat_<cv::Vec3b> seen(const Side& side, int pixels, const Framed& framed,
                           const BoneSet& marked = {}) const;

 private:
  PosedScene posed_;
  Framed framed_;
};

// A white page that pictures and words are put on.
class Page {
 public:
  Page(int width, int height);

  void place(const cv::Mat_<cv::Vec3b>& picture, int x, int y);
  void write(const std::string& text, int x, int y);  // the left end of the base line
  void write_small(const std::string& text, int x, int y);

  const ColorImage& image() const { return image_; }

 private:
  void write_sized(const std::string& text, int x, int y, double size);

  ColorImage image_;
};

}  // namespace graspdb
