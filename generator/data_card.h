// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "plan.h"

namespace graspdb {

// What the database is, what it was made of and under which licences, for whom it is and what it is
// not, as JSON (docs/data-card.md). It says what the plan's files say and nothing of when and where
// the database was made.
std::string data_card(const Plan& plan);

}  // namespace graspdb
