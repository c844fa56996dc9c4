// SPDX-License-Identifier: MIT
// From a camera's frame to a hand's pose: finds the hand, describes it, looks it up, and weighs
// what was found by what was known before.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/database/database.h"
#include "graspdb/database/search.h"
#include "graspdb/features/hand_follower.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// Frames of a left hand are mirrored on the way in, answers on the way out.
enum class Handedness {
  kRight,
  kLeft,
  kAuto,  // both are tried until frames have told, and again after a frame without a hand
};

struct ReaderOptions {
  std::optional<TrackerOptions> tracker;  // absent: kde, as tuned for the database's rows
  // By colour, unless told: {.net = std::make_shared<HandFinder>(HandFinder::load(file))}, where
  // finder_file("hand") is ours. Its `unlikeness` is unlikeness_to() unless one is given; with one
  // that is always 0 the net's hand is taken.
  FinderOptions finder;
  std::optional<Box> roi;  // pixels; the hand that is followed begins in it
  Handedness handedness = Handedness::kRight;
  bool still = false;  // frames are photographs that have nothing to do with each other
};

// How unlike the database's hands what is seen is: the distance of the nearest row, of either hand
// for kAuto, and 0 for a code that is very near. Readers with a learned finder choose by it; this
// is for those who find hands without a reader (FinderOptions). The search must outlive it. Without
// a describer it makes its own, and throws Error as that does.
HandUnlikeness unlikeness_to(const Database& database, const Search& search, Handedness handedness,
                             std::shared_ptr<const Describer> describer = nullptr);

class HandednessEvidence;

// Frames of one video, in their order. Not thread-safe; the database must outlive it, and so must a
// search that is given.
class HandReader {
 public:
  // Throws Error for a database of a descriptor that is not known and for an option out of range.
  explicit HandReader(const Database& database, const ReaderOptions& options = {},
                      const std::string& search = kDefaultSearch);
  ~HandReader();
  HandReader(HandReader&&) noexcept;
  // With a search, and a describer if one is given, that several readers share.
  HandReader(const Database& database, const Search& search, const ReaderOptions& options = {},
             std::shared_ptr<const Describer> describer = nullptr);

  // The pose of the hand in the next frame. Without a hand the estimate is invalid, and the past is
  // forgotten. Throws Error for a database whose rows were altered.
  Estimate read(const ColorImage& frame, const Intrinsics& camera);
  // The same with a mask of the hand, which may show its forearm too; of the frame's size.
  Estimate read(const ColorImage& frame, const Mask& mask, const Intrinsics& camera);

  // The two halves of read(), for several readers of the same frame.
  Observation observe(const ColorImage& frame, const Intrinsics& camera);
  Observation observe(GrayImage gray, const Mask& mask, const Intrinsics& camera) const;
  Estimate read(Observation seen);

  // The next frame is of another video.
  void forget();

  const Search& search() const { return *search_; }

 private:
  HandReader(const Database& database, const ReaderOptions& options,
             std::shared_ptr<const Search> search, std::shared_ptr<const Describer> describer);
  Estimate read_as(bool left, const Observation& seen);
  Estimate read_as_either(const Observation& seen);

  ReaderOptions options_;
  std::shared_ptr<const Search> search_;
  Tracker right_, left_;
  HandFollower follower_;
  std::unique_ptr<HandednessEvidence> evidence_;
};

}  // namespace graspdb
