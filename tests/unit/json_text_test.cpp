// The parser that reads all JSON.
#include "formats/text/json_text.h"

#include <gtest/gtest.h>

#include <array>

namespace talus::json_text_test {

std::string error_of(std::string_view text, std::int64_t first_line = 1) {
  const auto json = parse_json(text, {}, first_line);
  return json ? "" : json.error().place + ": " + json.error().message;
}

std::string lists_around(const std::string& value, std::size_t depth) {
  return std::string(depth, '[') + value + std::string(depth, ']');
}

TEST(JsonText, ValuesKeepTheirTypes) {
  const auto json =
      parse_json("\xef\xbb\xbf {\"a\": [1, -2, 0.5, true, null, \"x\\n\"],\n \"b\": {\"a\": {}}} \n");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(), R"({"a":[1,-2,0.5,true,null,"x\n"],"b":{"a":{}}})");
  EXPECT_EQ(parse_json("3")->dump(), "3");
  EXPECT_EQ(parse_json("18446744073709551615")->dump(), "18446744073709551615");
}

TEST(JsonText, ARepeatedKeyIsAnErrorWithItsPlace) {
  EXPECT_EQ(error_of("{\"a\": 1,\n\"b\": 2,\n \"a\": 3}"), "line 3, key a: is twice in one object");
  EXPECT_EQ(error_of(R"({"map": [0, {"rows": 1, "x": {}, "rows": 2}]})"),
            "line 1, key map[1].rows: is twice in one object");
  EXPECT_EQ(error_of(R"([{"a": 1}, {"a": 1}])"), "") << "of two objects";
  EXPECT_EQ(error_of(R"({"a": 1, "\u0061": 2})"), "line 1, key a: is twice in one object");
}

TEST(JsonText, KeysOfTheDocumentItselfAreFound) {
  constexpr std::array<std::string_view, 2> kWanted = {"a", "b"};
  const auto has = [&](std::string_view text) { return has_key(text, kWanted); };
  EXPECT_TRUE(has(R"({"x":{"y":[1,"a"]},"b":2})"));
  EXPECT_TRUE(has(R"({"\u0061": damaged)"));
  EXPECT_FALSE(has(R"({"x":{"a":1},"y":["a",{"b":1}],"z":"a"})"));
  EXPECT_FALSE(has(R"([{"a":1}])"));
  EXPECT_FALSE(has(R"({"x": damaged, "a":1})"));
  EXPECT_FALSE(has(""));
  EXPECT_FALSE(has("{\"x\":" + lists_around("1", 100'000) + "}"));
}

TEST(JsonText, NothingMayFollowTheEnd) {
  EXPECT_EQ(error_of("{} x"), "line 1, column 4: this is not valid JSON");
  EXPECT_EQ(error_of("{}\n{}"), "line 2, column 1: this is not valid JSON");
  EXPECT_EQ(error_of(std::string_view("{}\n\0{\"talus\": 1}", 17)),
            "line 2, column 1: this is not valid JSON");
  EXPECT_EQ(error_of(std::string_view("\0", 1)), "line 1, column 1: this is not valid JSON");
  EXPECT_EQ(error_of(""), "line 1, column 1: this is not valid JSON");
}

TEST(JsonText, DepthIsBounded) {
  EXPECT_EQ(error_of(lists_around("1", 64)), "");
  EXPECT_EQ(error_of("\n" + lists_around("1", 65)), "line 2: the JSON is nested deeper than 64 levels here");
  EXPECT_EQ(error_of(lists_around("1", 100'000)), "line 1: the JSON is nested deeper than 64 levels here");
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += R"({"keys":)";
  EXPECT_EQ(error_of(keys), "line 1: the JSON is nested deeper than 64 levels here");
}

TEST(JsonText, TheNumberOfValuesIsBounded) {
  std::string text = "[0";
  for (int i = 0; i < kMaxJsonValues; ++i) text += ",0";
  EXPECT_EQ(error_of(text + "]"), "line 1: the JSON has more than 5000000 values");
  EXPECT_EQ(error_of("[x," + text), "line 1: the JSON has more than 5000000 values")
      << "the values are counted before any is made";
  text = "[\t0";
  for (int i = 0; i < kMaxJsonValues - 2; ++i) text += ",0";
  EXPECT_EQ(error_of(text + ",\"[,\\\",,\"]"), "line 1: the JSON has more than 5000000 values");
  EXPECT_EQ(error_of(text + "\r\n]"), "") << "exactly at the limit";
}

TEST(JsonText, NumbersTooLargeForADoubleAreErrors) {
  EXPECT_EQ(error_of(R"({"a": [{"b": 1}, {"c": -1e999}]})"),
            "line 1, key a[1].c: has a number that is too large");
  EXPECT_EQ(error_of("[1, 1e999]"), "line 1, key [1]: has a number that is too large");
  EXPECT_EQ(error_of("[NaN]"), "line 1, column 2: this is not valid JSON");
}

TEST(JsonText, ErrorsCountTheLinesOfTheFile) {
  EXPECT_EQ(error_of("{\"a\": }", 7), "line 7, column 7: this is not valid JSON");
  EXPECT_EQ(error_of("[[],\n{\"a\": 1, \"a\": 2}]", 7), "line 8, key [1].a: is twice in one object");
}

TEST(JsonText, WholeNumbersDoNotWrapAround) {
  const auto is = [](std::string_view text) { return is_whole(*parse_json(text), -999, 999); };
  EXPECT_TRUE(is("-999"));
  EXPECT_TRUE(is("999"));
  EXPECT_FALSE(is("1000"));
  EXPECT_FALSE(is("1.0"));
  EXPECT_FALSE(is("\"1\""));
  EXPECT_FALSE(is("18446744073709551116")) << "-500 in 64 bits";
  EXPECT_FALSE(is("9223372036854775808"));
}

}  // namespace talus::json_text_test
