// SPDX-License-Identifier: MIT
// What is wrong with a file of weights, and what the message must name.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "features/net_bytes.h"
#include "graspdb/core/error.h"

namespace graspdb::testing {

struct NetFault {
  const char* name;
  std::function<void(NetFile&)> make;
  const char* message;
};

inline void expect_refused(const NetFault& fault, NetFile file,
                           const std::function<void(std::string, const std::string&)>& parse) {
  fault.make(file);
  try {
    parse(file.bytes(), "some.safetensors");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("some.safetensors"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(fault.message));
  }
}

}  // namespace graspdb::testing
