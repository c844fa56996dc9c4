// SPDX-License-Identifier: MIT
#include "graspdb/core/json/strict_json.h"

#include <gtest/gtest.h>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using nlohmann::json;

json parsed(const std::string& text) {
  return parse_strict_json(text, "f.json", "");
}

// The fault that reading gives, without its file, which must be f.json.
std::string fault_of(const auto& reading) {
  try {
    reading();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().file, "f.json");
    return error.fault().key + ": " + error.fault().expected + ": " + error.fault().found;
  }
  return "none";
}

std::string fault_in(const std::string& text, const auto& reading) {
  const json object = parsed(text);
  return fault_of([&] { reading(JsonFields(object, "f.json", "at")); });
}

TEST(StrictJson, ATextThatIsNoJsonOrSaysAKeyTwiceOrNestsTooDeepIsRefused) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("{\"a\": 1e999}"), std::string("{} {}"),
        std::string("{\"a\": \"\xff\"}"), std::string("{\"a\": NaN}"),
        std::string("{\"a\": {\"b\": 1, \"b\": 1}}"), std::string(100'000, '[')}) {
    EXPECT_NE(fault_of([&] { parsed(text); }), "none") << text.substr(0, 40);
  }
  EXPECT_EQ(parsed(std::string(16, '[') + std::string(16, ']')).size(), 1u);
  EXPECT_NE(fault_of([] { parsed(std::string(18, '[') + std::string(18, ']')); }), "none");
}

TEST(StrictJson, WholeNumbersMustBeWholeAndInRangeHoweverLarge) {
  const auto read = [](const JsonFields& fields) { fields.integer("n", 1, 100'000); };
  EXPECT_EQ(fault_in(R"({"n": 100000})", read), "none");
  EXPECT_EQ(fault_in(R"({"n": 100001})", read), "at.n: a whole number from 1 to 100000: 100001");
  // The last is 5 below 2^64 - 2^32, and 5 when cut to 32 bits.
  for (const char* number : {"0", "-1", "2.5", "1e3", "true", "null", "\"3\"", "[3]",
                             "9223372036854775808", "18446744069414584325"}) {
    EXPECT_NE(fault_in("{\"n\": " + std::string(number) + "}", read), "none") << number;
  }
}

TEST(StrictJson, NumbersMustBeNumbersAndOfTheirCount) {
  const auto number = [](const JsonFields& fields) { fields.number("n"); };
  EXPECT_EQ(fault_in(R"({"n": -2})", number), "none");
  EXPECT_EQ(fault_in(R"({"n": true})", number), "at.n: a number: true");
  const auto positive = [](const JsonFields& fields) { fields.positive("n"); };
  EXPECT_EQ(fault_in(R"({"n": 1e-9})", positive), "none");
  EXPECT_EQ(fault_in(R"({"n": 0})", positive), "at.n: a number above 0: 0");
  const auto vector = [](const JsonFields& fields) { fields.matrix<Eigen::Vector3d>("n"); };
  EXPECT_EQ(fault_in(R"({"n": [1, 2, 3.5]})", vector), "none");
  EXPECT_EQ(fault_in(R"({"n": [1, 2]})", vector), "at.n: 3 numbers: 2");
  EXPECT_EQ(fault_in(R"({"n": [1, null, 3]})", vector), "at.n: 3 numbers: null");
  EXPECT_EQ(fault_in(R"({"n": {"0": 1, "1": 2, "2": 3}})", vector), "at.n: 3 numbers: object");
  const auto points = [](const JsonFields& fields) { fields.points("n", 2); };
  EXPECT_EQ(fault_in(R"({"n": [[1, 2, 3], [4, 5, 6]]})", points), "none");
  EXPECT_EQ(fault_in(R"({"n": [[1, 2, 3]]})", points), "at.n: 2 points: array");
  EXPECT_EQ(fault_in(R"({"n": [[1, 2, 3], [4, 5]]})", points), "at.n: 3 numbers: 2");
}

TEST(StrictJson, AMatrixIsReadRowByRow) {
  const json object = parsed(R"({"m": [1, 2, 3, 4, 5, 6]})");
  const auto m = JsonFields(object, "f", "").matrix<Eigen::Matrix<double, 2, 3>>("m");
  EXPECT_EQ(m, (Eigen::Matrix<double, 2, 3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(StrictJson, WhatIsAbsentOrNoObjectIsNamedWithItsWholeKey) {
  const auto inner = [](const JsonFields& fields) { fields.fields("a").fields("b").text("c"); };
  EXPECT_EQ(fault_in(R"({"a": {"b": {"c": "x"}}})", inner), "none");
  EXPECT_EQ(fault_in(R"({"a": {"b": {}}})", inner), "at.a.b.c: an entry: none");
  EXPECT_EQ(fault_in(R"({"a": {"b": 3}})", inner), "at.a.b: an object: number");
  EXPECT_EQ(fault_in(R"({"a": {"b": {"c": 3}}})", inner), "at.a.b.c: a text: 3");
}

}  // namespace
}  // namespace graspdb
