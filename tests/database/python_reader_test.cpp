// SPDX-License-Identifier: MIT
// python/graspdb_reader.py reads what C++ writes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

// Prints what the reader sees: sums weighted by position, so that a value in a wrong place shows.
constexpr const char* kScript = R"(
import sys
sys.path.insert(0, sys.argv[1])
import numpy, graspdb_reader
d = graspdb_reader.Database(sys.argv[2])
weigh = lambda a: int((a.astype("f8").ravel() * (1 + numpy.arange(a.size))).sum() * 256)
print(d.rows, *(weigh(d.columns[c]) for c in "label view grasp hog step hand variant".split()))
print(d.angles().shape, d.label_names[2], d.label_names[3], d.label_names[30], len(d.label_names))
print(d.grasps, d.variants, d.steps, d.views, d.hands[0]["name"])
)";

template <typename T, typename Get>
long long weighed(const std::vector<Row>& rows, Get get) {
  double sum = 0, place = 0;
  for (const Row& row : rows) {
    for (const T value : get(row)) sum += static_cast<double>(value) * ++place;
  }
  return static_cast<long long>(sum * 256);
}

template <typename T>
long long weighed(const std::vector<Row>& rows, T Row::*field) {
  return weighed<T>(rows, [&](const Row& row) { return std::array<T, 1>{row.*field}; });
}

std::string expected_output(const std::vector<Row>& rows) {
  return fmt::format(
      "{} {} {} {} {} {} {} {}\n({}, 28) camera_from_hand_z wrist_flexion little_dip_flexion 31\n"
      "{{1: 'Large Diameter', 9: 'Palmar Pinch'}} ['held', 'free'] 5 8 toy\n",
      rows.size(), weighed<float>(rows, [](const Row& row) { return row.label; }),
      weighed(rows, &Row::view), weighed(rows, &Row::grasp),
      weighed<std::uint8_t>(rows, [](const Row& row) { return row.hog; }),
      weighed(rows, &Row::step), weighed(rows, &Row::hand), weighed(rows, &Row::variant),
      rows.size());
}

// A python3 that has numpy: the first on the path need not.
std::string python_with_numpy() {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const std::string probe = fmt::format("{} -c 'import numpy' 2>/dev/null", python);
    if (std::system(probe.c_str()) == 0) return python;
  }
  return {};
}

class PythonReader : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Rows, PythonReader, ::testing::Values(0, 1, 100));

TEST_P(PythonReader, SeesEveryValueThatWasWritten) {
  const std::string python = python_with_numpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy (Debian: python3-numpy)";
  const testing::TemporaryDirectory directory;
  const std::vector<Row> rows = testing::toy_rows(GetParam());
  write_database(directory / "a.graspdb", testing::toy_info(), rows);
  write_text(directory / "script.py", kScript);
  const std::string command = fmt::format(
      "{} -B '{}' '{}/python' '{}' > '{}'", python, (directory / "script.py").string(),
      GRASPDB_SOURCE_DIR, (directory / "a.graspdb").string(), (directory / "out").string());
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  EXPECT_EQ(read_text(directory / "out"), expected_output(rows));
}

}  // namespace
}  // namespace graspdb
