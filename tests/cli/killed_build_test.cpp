// SPDX-License-Identifier: MIT
// A build that is killed at any moment goes on when the same command is given again.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "graspdb/core/random.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Outcome;
using testing::run_program;

// Environment variables for as long as it lives.
class Environment {
 public:
  void set(const char* name, const std::string& value) {
    ::setenv(name, value.c_str(), 1);
    names_.insert(name);
  }
  ~Environment() {
    for (const char* name : names_) ::unsetenv(name);
  }

 private:
  std::set<const char*> names_;
};

class KilledBuild : public ::testing::Test {
 protected:
  // Four shards.
  Outcome build(const std::string& name) const {
    return run_program(
        "build --json --only 3,9 --objects both --steps 1 --views 12 "
        "--resolution 32 --threads 1 --out " +
        (directory_ / name).string());
  }

  Outcome build_killed_at(const std::string& name, long call) const {
    Environment environment;
    environment.set("LD_PRELOAD", GRASPDB_KILL_AT_CALL);
    environment.set("GRASPDB_KILL_AT", std::to_string(call));
    environment.set("GRASPDB_COUNT_CALLS", "1");
    return build(name);
  }

  testing::TemporaryDirectory directory_;
};

TEST_F(KilledBuild, GoesOnToTheSameContentFromTwentyMoments) {
  const Outcome whole = build_killed_at("whole", 1'000'000);
  ASSERT_EQ(whole.code, 0) << whole.err;
  const std::string hash = json::parse(whole.out).at("content_hash");
  const std::size_t at = whole.err.find("file calls: ");
  ASSERT_NE(at, std::string::npos) << whole.err;
  const long calls = std::atol(whole.err.c_str() + at + 12);
  ASSERT_GT(calls, 40);  // the last of them: merging, and renaming the database
  std::set<long> moments = {1, calls - 1, calls};
  RandomStream random(5);
  while (moments.size() < 20) {
    moments.insert(1 + static_cast<long>(random.below(static_cast<std::uint32_t>(calls))));
  }
  for (const long moment : moments) {
    const std::string name = fmt::format("killed{}", moment);
    const Outcome killed = build_killed_at(name, moment);
    ASSERT_NE(killed.code, 0) << moment;
    const fs::path out = directory_ / name;
    EXPECT_FALSE(fs::exists(out)) << moment;
    const Outcome resumed = build(name);
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(json::parse(resumed.out).at("content_hash"), hash) << moment;
    for (const auto& entry : fs::recursive_directory_iterator(out.string() + ".work")) {
      EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
    }
  }
}

}  // namespace
}  // namespace graspdb
