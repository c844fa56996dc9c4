// SPDX-License-Identifier: MIT
#pragma once

#include "mesher.h"

namespace graspdb {

// Collapses edges in the order of their quadric error (Garland and Heckbert 1997) until
// `triangle_count` are left. The surface stays a closed 2-manifold; no triangle turns over.
// Deterministic.
// Vertices marked in `kept` stay as they are.
RawMesh simplified(const RawMesh& mesh, std::size_t triangle_count, const std::vector<bool>& kept);

}  // namespace graspdb
