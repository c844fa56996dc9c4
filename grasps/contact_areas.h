// SPDX-License-Identifier: MIT
// The names of the parts of a hand that touch things, as grasp files use them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graspdb/grasps/grasp.h"

namespace graspdb {

// Empty for a name that this digit (0 palm, 1 thumb .. 5 little) does not have.
std::optional<ContactArea> contact_area(int digit, std::string_view name);

std::string contact_area_names(int digit);  // for messages: "pulp, tip, ..."

// The number of a digit's name; empty for another word.
std::optional<int> digit_from_name(std::string_view name);

}  // namespace graspdb
