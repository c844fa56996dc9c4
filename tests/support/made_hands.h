// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace graspdb::testing {

// The default hands that tests make anew. Under the address sanitizer a hand takes more than ten
// seconds, and the second one walks the same code.
inline std::vector<std::string> made_hands() {
#ifdef __SANITIZE_ADDRESS__
  return {"male"};
#else
  return {"male", "female", "slender", "child"};
#endif
}

}  // namespace graspdb::testing
