// SPDX-License-Identifier: MIT
// A .glb that is altered at any byte is nearly always one whose lengths are wrong or whose JSON
// ends too soon. This alters one of its two parts and puts them together again.
#pragma once

#include "graspdb/core/assimp/glb.h"
#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "memory_file.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace graspdb::testing {

inline std::string altered(std::string part, std::size_t room) {
  const std::size_t size = part.size();
  part.resize(size + room);
  auto* bytes = reinterpret_cast<std::uint8_t*>(part.data());
  part.resize(LLVMFuzzerMutate(bytes, size, part.size()));
  return part;
}

// The whole altered file; empty when `bytes` are no .glb.
inline std::string altered_glb(std::string_view bytes, RandomStream& random) {
  constexpr std::size_t kRoom = 64;
  try {
    const GlbParts parts = glb_parts(bytes, "");
    std::string json(parts.json), binary(parts.binary);
    if (random.below(4) == 0) {
      binary = altered(binary, kRoom);
      binary.resize((binary.size() + 3) / 4 * 4);
    } else {
      json = altered(json, kRoom);
    }
    return glb_file(json, binary);
  } catch (const Error&) {
    return "";
  }
}

inline std::size_t mutate_glb(std::uint8_t* data, std::size_t size, std::size_t max_size,
                              unsigned seed) {
  RandomStream random(seed);
  const std::string file = random.below(8) == 0 ? "" : altered_glb(text_of(data, size), random);
  if (file.empty() || file.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::copy(file.begin(), file.end(), data);
  return file.size();
}

}  // namespace graspdb::testing

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return graspdb::testing::mutate_glb(data, size, max_size, seed);
}
