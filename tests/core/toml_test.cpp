// SPDX-License-Identifier: MIT
#include "graspdb/core/toml.h"

#include <gmock/gmock.h>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Toml, ReadsWhatIsThere) {
  const TomlTable table = TomlTable::parse("a = 1.5\nb = 'x'\n[c]\nd = [1, 2.5]", "f.toml");
  EXPECT_EQ(table.number("a", 0, 2), 1.5);
  EXPECT_EQ(table.string("b"), "x");
  EXPECT_EQ(table.table("c").numbers("d", 2, 0, 9), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(table.number_or("none", 7, 0, 9), 7);
  table.finish();
}

TEST(Toml, NamesFileKeyExpectationAndFinding) {
  const TomlTable table = TomlTable::parse("[pose]\npip_deg = 400", "grasp.toml");
  EXPECT_THAT(message_of([&] { table.table("pose").number("pip_deg", -10, 110); }),
              AllOf(HasSubstr("grasp.toml"), HasSubstr("'pose.pip_deg'"),
                    HasSubstr("from -10 to 110"), HasSubstr("found 400")));
}

TEST(Toml, AVectorHasThreeNumbersInRange) {
  const TomlTable table =
      TomlTable::parse("v = [1, 2.5, -3]\nshort = [1, 2]\nfar = [0, 0, 9]", "f");
  EXPECT_EQ(table.vector3("v", -3, 3), Eigen::Vector3d(1, 2.5, -3));
  EXPECT_THAT(message_of([&] { table.vector3("short", -3, 3); }), HasSubstr("'short'"));
  EXPECT_THAT(message_of([&] { table.vector3("far", -3, 3); }), HasSubstr("found 9"));
}

TEST(Toml, AChoiceIsOneOfTheNames) {
  const TomlTable table = TomlTable::parse("side = 'left'\nunit = 'inch'", "f");
  EXPECT_EQ(table.choice("side", {"left", "right"}), "left");
  EXPECT_THAT(message_of([&] {
                table.choice("unit", {"mm", "cm"});
              }),
              HasSubstr("'unit': expected one of mm, cm, found \"inch\""));
  EXPECT_THAT(message_of([&] { table.choice("none", {"mm", "cm"}); }), HasSubstr("'none'"));
}

TEST(Toml, AnyTextReturnsFromItsQuotes) {
  std::string text = "a \"quote\", a \\, ü";
  for (char c = 1; c < 0x20; ++c) text += c;
  text += '\x7f';
  const std::string written = toml_string(text);
  EXPECT_EQ(written.find('\n'), std::string::npos);
  EXPECT_EQ(TomlTable::parse("name = " + written, "f").string("name"), text);
}

TEST(Toml, RefusesUnknownKeysNotANumberAndBrokenText) {
  const TomlTable table = TomlTable::parse("good = 1\nbda = 2\nx = nan", "f");
  EXPECT_EQ(table.integer("good", 0, 3), 1);
  EXPECT_THAT(message_of([&] { table.number("x", 0, 1); }), HasSubstr("'x'"));
  EXPECT_THAT(message_of([&] { table.finish(); }), HasSubstr("'bda'"));
  EXPECT_THAT(message_of([] { TomlTable::parse("a = [", "broken.toml"); }),
              HasSubstr("broken.toml"));
}

}  // namespace
}  // namespace graspdb
