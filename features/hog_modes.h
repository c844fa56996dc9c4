// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/core/descriptor.h"
#include "graspdb/core/image.h"

namespace graspdb {

constexpr int kCells = 8;  // a side
constexpr int kBins = 8;   // 22.5 degrees each, unsigned

// The pixels inside `box`, which is not empty, described as the modes of hog.h say.
Descriptor describe_paper(const GrayImage& gray, const Mask& mask, const Box& box);
Descriptor describe_soft_edges(const GrayImage& gray, const Mask& mask, const Box& box);

}  // namespace graspdb
