// SPDX-License-Identifier: MIT
// Measures a hand against what a hand must be, a line a property: value, gate and verdict. Works on
// any hand that load_hand reads, whoever made it and with however few triangles.
//
// Where a value is the worst of many, `why` says where that was. A line that a hand lacks the parts
// for (no skin on its forearm or on a fingertip, a volume of an open surface) is not applicable,
// and `why` says what is missing. Such a line never passes silently.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graspdb/hand/hand.h"

namespace graspdb {

struct HandCheckLine {
  enum class Status { kPass, kFail, kNotApplicable };

  std::string name;  // e.g. "volume change, fist"; the names and their order are fixed
  double value;      // NaN when it could not be measured
  std::string unit;  // "mm", "%", "deg", "cm3"; empty for counts and ratios
  std::string gate;  // e.g. "<= 2", "-3..3"; empty when nothing was asked for
  Status status;
  std::string why;
};

std::string_view status_name(HandCheckLine::Status status);  // "pass", "fail", "not applicable"

// True when no line fails.
bool passes(std::span<const HandCheckLine> lines);

// What the hand was made to measure.
struct AskedSize {
  double length_mm, breadth_mm;
};

// All lines that follow from the hand alone. "At a limit" means one angle at the lower or upper end
// of its range (angles.h), all others at zero; the poses are named_poses.h's.
//
//   open edges             edges that do not have exactly two triangles
//   pinched vertices       vertices whose triangles form more than one fan
//   turned edges           edges that both their triangles pass in the same direction
//   Euler number           vertices - edges + triangles, of one closed piece without handles 2;
//                          `why` names the pieces apart from the largest
//   volume                 enclosed in the bind pose
//   triangle quality       the least 4 sqrt(3) area / (sum of squared sides): 1 for equal sides
//   longest edge           outside the forearm's cap: triangles within 3 mm of the skin's far end
//   inverted triangles     triangles whose posed face looks away from where it should: its face
//                          normal in the bind pose, turned by each bone and blended by the weights
//                          of its corners. A count in flat, wrap and pinch; else a share of all
//                          triangles: in the fist, and at the worst of the limits of wrist, thumb
//                          and fingers
//   inverted and seen      those of them at a limit that no skin covers on the way out from their
//                          middle: inverted elsewhere than in a fold
//   volume change          against the bind pose, of the whole skin; and the worst of the thumb's
//                          limits
//   PIP section            from the PIP joint's centre, along the bisector of the backs of the two
//                          phalanges, to the skin: at 105 degrees of flexion, of its value when
//                          straight
//   pulp gap, pulp facing  a digit's pulp is where a line from 65 % of its distal bone, palmar,
//                          leaves the skin; it looks as that line goes. Where thumb and finger meet
//                          best within their ranges, as a search finds: the distance of the two
//                          pulps, and the angle that is missing for them to look at each other
//   tip to palm            in the fist, least distance of the skin of the finger's distal half bone
//                          from that of palm and metacarpals; 0 where they meet
//   hand length            flat hand, wrist joint to the most distal skin of the middle finger
//   hand breadth           flat hand, skin without thumb and forearm, cut through the index's and
//                          the little finger's knuckles at a right angle to the palm: its width
//                          along the line through the two knuckles
//   skin follows           an angle moves the bones beyond its joint and nothing else. Skin nearer
//                          to those bones (in the bind pose) should follow them by more than half,
//                          all other skin by less. By how much nearer the wrong side was, at the
//                          vertex that does worst, in percent of the hand's length: neighbouring
//                          fingers are 10 % apart. Palm and thenar share their flesh, so that
//                          wrist and CMC joints have a wider gate
//   direction              between the way in which an angle's first 15 degrees move the last skin
//                          that it moves, and the way they should: palmar for flexion (the thumb's:
//                          ulnar), radial for abduction and deviation, palmar for the thumb's
//                          abduction; for its axial angle, of the way the pulp turns: dorsal, to
//                          the fingers, from 45 degrees of abduction. At a right angle to the lever
//   palm side              how many of the signs of palm_side.h say that the palm is the back
//   nail                   a digit's end is flat on its nail and on its pulp: between the axis that
//                          most of its skin faces along, seen along the bone, and its frame's
//                          dorsal, 0..90 degrees. Not applicable to an end that is round. It does
//                          not tell the nail from the pulp: `direction` does
//   tips on the skin       how far a digit's tip lies from the skin of its last bone, or how much
//                          of that skin lies beyond it, along the bone
//
// Pure, deterministic and thread-safe; a fraction of a second for 10,000 triangles.
std::vector<HandCheckLine> check_hand(const Hand& hand,
                                      const std::optional<AskedSize>& asked = std::nullopt);

// "made again": the largest difference in any coordinate of skin and joints, entry of a frame, or
// weight between a hand's file and the same hand made anew; infinite when the triangles differ, not
// applicable when there is none.
HandCheckLine check_made_again(const Hand& from_file, const std::optional<Hand>& made);

}  // namespace graspdb
