// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "graspdb/core/descriptor.h"

namespace graspdb {

// Squared distances between descriptors, in integers: the same on every processor. `rows` holds
// descriptors of the query's size one behind the other; that is a multiple of kEmbeddingBlock.

// To the first squared.size() of them.
void squared_distances(DescriptorView query, const std::uint8_t* rows,
                       std::span<std::uint32_t> squared);

// To those at these places; squared has the size of `places`.
void squared_distances(DescriptorView query, const std::uint8_t* rows,
                       std::span<const std::uint32_t> places, std::span<std::uint32_t> squared);

}  // namespace graspdb
