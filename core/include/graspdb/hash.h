// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace graspdb {

// The XXH3 128-bit hash of some bytes, as 32 hexadecimal digits. It finds accidents, not forgers.
std::string hash_hex(std::span<const std::byte> bytes);
std::string hash_hex(std::string_view text);

}  // namespace graspdb
