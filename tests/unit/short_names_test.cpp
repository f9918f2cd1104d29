// Short names for the local variables of code in carts.
#include "export/short_names.h"

#include <gtest/gtest.h>

namespace talus::short_names_test {

TEST(ShortNames, OfLocalsParametersAndFunctions) {
  EXPECT_EQ(with_short_names(
                "local counter, limit = 0, 10\nlocal function raise(step) counter = counter + step end\n"
                "for index = 1, limit do raise(index) end\n"),
            "local a, c = 0, 10\nlocal function d(e) a = a + e end\nfor b = 1, c do d(b) end\n");
}

TEST(ShortNames, FieldsMethodsKeysAndStringsStay) {
  const std::string code =
      "local world = {size = 1, name = \"size world\"}\nfunction world:grow(size) self.size = size end\n"
      "function world.make(name) return {world.size, name = name} end\n";
  EXPECT_EQ(with_short_names(code),
            "local a = {size = 1, name = \"size world\"}\nfunction a.grow(c,d) c.size = d end\n"
            "function a.make(b) return {a.size, name = b} end\n");
}

// The locals of a function in a table are no keys, and a comparison in a table is none.
TEST(ShortNames, OfLocalsThatAreFieldsElsewhere) {
  const std::string code =
      "local left, top = 1, 2\nlocal box = {left = left,\ntop = function(left) local top = 1\n"
      "if left then left, top = top, left end\nreturn top end, left == top, [left] = 1}\n"
      "for left = 1, 2 do box.left = box.left .. left end\nreturn box\n";
  EXPECT_EQ(with_short_names(code),
            "local a, b = 1, 2\nlocal c = {left = a,\ntop = function(a) local b = 1\n"
            "if a then a, b = b, a end\nreturn b end, a == b, [a] = 1}\n"
            "for a = 1, 2 do c.left = c.left .. a end\nreturn c\n");
}

constexpr std::string_view kTables[] = {"Walk"}, kFields[] = {"slope_rest", "edge"};

TEST(ShortNames, OfMethodsOfInnerTablesThatNothingElseHas) {
  const std::string code =
      "local Walk, World = {}, {}\nfunction Walk:turn() return self.ahead end\nfunction Walk.ahead() end\n"
      "function Walk.slack(walk) return walk:turn() + Walk.slack(walk) end\n"
      "function World:floor() return (\"\"):format() end\nfunction Walk:floor() return self:format() end\n";
  EXPECT_EQ(with_short_names(code, {.tables = kTables}),
            "local a, d = {}, {}\nfunction a.f(b) return b.ahead end\nfunction a.ahead() end\n"
            "function a.e(c) return c:f() + a.e(c) end\n"
            "function d.floor(b) return (\"\"):format() end\nfunction a.floor(b) return b:format() end\n");
}

TEST(ShortNames, OfInnerFields) {
  const std::string code = "local line = {slope_rest = 1, slope = 2}\nline.slope = line.edge.slope_rest\n";
  EXPECT_EQ(with_short_names(code, {.fields = kFields}), "local b = {a = 1, slope = 2}\nb.slope = b.c.a\n");
}

TEST(ShortNames, NamesOfLuaAndGlobalsStay) {
  EXPECT_EQ(with_short_names("local floor = math.floor\nprint(floor(x), pairs, type)\n"),
            "local a = math.floor\nprint(a(x), pairs, type)\n");
  EXPECT_EQ(with_short_names("local function kind(type) return type .. kind end\n"),
            "local function a(type) return type .. a end\n");
}

TEST(ShortNames, AreNotNamesThatTheCodeHas) {
  EXPECT_EQ(with_short_names("local first, a, b = 1, 2, c\nreturn first\n"),
            "local d, a, b = 1, 2, c\nreturn d\n");
}

}  // namespace talus::short_names_test
