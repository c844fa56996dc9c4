// SPDX-License-Identifier: MIT
// Tests that run once with each instruction set that this processor has.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <string>
#include <vector>

namespace graspdb::testing {

class InstructionSet : public ::testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { use_param(); }
  void TearDown() override { use_best(); }

  static void use_param() { use(GetParam()); }
  static void use_best() { use(0); }

 private:
  static void use(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

inline auto each_instruction_set() {
  std::vector<std::int64_t> each;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    each.push_back(left & -left);
  }
  return ::testing::ValuesIn(each);
}

inline std::string instruction_set_name(const ::testing::TestParamInfo<std::int64_t>& of) {
  return hwy::TargetName(of.param);
}

}  // namespace graspdb::testing
