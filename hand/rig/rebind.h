// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/hand/hand.h"

namespace graspdb {

// The same hand bound with its digits half bent. Linear blending thins a joint by cos(a / 2) at a
// bend of `a` from the bind pose, so that a hand bound flat has PIP joints of 61 % of their
// thickness at 105 degrees; from the middle of the range none bends half as far. The skin is
// taken there by dual quaternions, which keep a joint's thickness (Kavan, Collins, Zara,
// O'Sullivan: Skinning with Dual Quaternions, I3D 2007).
Hand bound_half_bent(Hand hand);

}  // namespace graspdb
