// SPDX-License-Identifier: MIT
// Which side of a hand is its palm, told by more than one sign. Whether a file holds a right or a
// left hand is stated by its rig map; told wrongly, palm and back change places, and every finger
// bends the wrong way.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graspdb/hand/hand.h"

namespace graspdb {

// One sign in the bind pose, seen as if the palm were where the hand's frame has it.
struct PalmWitness {
  enum class Verdict { kAgrees, kTellsNothing, kContradicts };

  std::string seen;  // e.g. "the thumb's root 8 mm palmar of wrist and knuckles"
  Verdict verdict;
};

// Four signs, always in this order:
//   the thumb's root     lies palmar of the plane through the wrist and the two outer knuckles
//   the fingers' bend    of PIP and DIP joint together: nobody's bend back by 30 degrees
//   the palm's flesh     lies for the most part palmar of the metacarpals
//   the fingertips'      likewise: the pulps
// A sign that is too faint, or that there is no skin for, tells nothing. The thumb's nail is no
// sign: it faces the thumb's side on either hand. Pure, thread-safe, some milliseconds.
std::vector<PalmWitness> palm_witnesses(const Hand& hand);

std::ptrdiff_t count_of(const std::vector<PalmWitness>& witnesses, PalmWitness::Verdict verdict);

// What was seen by those with this verdict, joined by ", "; empty when there is none.
std::string seen_by(const std::vector<PalmWitness>& witnesses, PalmWitness::Verdict verdict);

}  // namespace graspdb
