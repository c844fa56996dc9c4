// SPDX-License-Identifier: MIT
#include "checks.h"

#include <gmock/gmock.h>

#include <limits>

namespace graspdb::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// What the check says of a text; nothing when it is well.
std::string told(const CLI::Validator& check, std::string text) {
  return check(text);
}

TEST(Checks, ARangeHoldsNumbersOnly) {
  const CLI::Validator check = range(0.5, 20.0);
  for (const char* good : {"0.5", "20", "+3", "1e1", ".7"})
    EXPECT_THAT(told(check, good), IsEmpty());
  for (const char* bad :
       {"nan", "-nan", "NAN", "inf", "0.4", "20.1", "", " 1", "1 ", "1x", "0x10", "1e999", "1,5"}) {
    EXPECT_THAT(told(check, bad), HasSubstr("expected a number, 0.5 to 20")) << bad;
  }
}

TEST(Checks, AWholeNumberIsReadAsItIsWritten) {
  const CLI::Validator check = range(-5, 20);
  for (const char* good : {"0", "-5", "20", "+3"}) EXPECT_THAT(told(check, good), IsEmpty());
  for (const char* bad :
       {"010", "-05", "0x10", "1.5", "1e1", "nan", "", "21", "-6", "99999999999999999999999"}) {
    EXPECT_THAT(told(check, bad), HasSubstr("a whole number, -5 to 20")) << bad;
  }
  EXPECT_EQ(range(1, std::numeric_limits<int>::max()).get_description(), "1 or more");
}

TEST(Checks, ASeedIsNotNegative) {
  EXPECT_THAT(told(natural(), "18446744073709551615"), IsEmpty());
  for (const char* bad : {"-1", "18446744073709551616", "nan", ""})
    EXPECT_THAT(told(natural(), bad), HasSubstr("0 or more")) << bad;
}

TEST(Checks, ANameStandsForItsValueAndANumberForNone) {
  enum Color { kRed = 3, kBlue = 7 };
  const CLI::Validator check = named<Color>({{"red", kRed}, {"blue", kBlue}});
  std::string text = "blue";
  EXPECT_THAT(check(text), IsEmpty());
  EXPECT_EQ(text, "7");
  for (const char* bad : {"7", "Blue", "", "green"})
    EXPECT_THAT(told(check, bad), HasSubstr("one of blue, red")) << bad;
}

TEST(Checks, AFileOfAnotherFormatIsNotWritten) {
  const CLI::Validator check = output_file({".png"});
  EXPECT_THAT(told(check, "sheet.PNG"), IsEmpty());
  for (const char* bad : {"sheet.jpg", "sheet", ".png"})
    EXPECT_FALSE(told(check, bad).empty()) << bad;
  EXPECT_THAT(told(output_file_or_dash(), "-"), IsEmpty());
}

}  // namespace
}  // namespace graspdb::cli
