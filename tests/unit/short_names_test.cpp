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
            "local a = {size = 1, name = \"size world\"}\nfunction a:grow(size) self.size = size end\n"
            "function a.make(name) return {a.size, name = name} end\n");
}

TEST(ShortNames, OfMethodsOfInnerTablesThatNothingElseHas) {
  const std::string code =
      "local Walk, World = {}, {}\nfunction Walk:turn() return self.ahead end\nfunction Walk.ahead() end\n"
      "function Walk.slack(walk) return walk:turn() + Walk.slack(walk) end\n"
      "function World:floor() return (\"\"):format() end\nfunction Walk:floor() return self:format() end\n";
  EXPECT_EQ(with_short_names(code, {"Walk"}),
            "local a, c = {}, {}\nfunction a:e() return self.ahead end\nfunction a.ahead() end\n"
            "function a.d(b) return b:e() + a.d(b) end\n"
            "function c:floor() return (\"\"):format() end\nfunction a:floor() return self:format() end\n");
}

TEST(ShortNames, NamesOfLuaAndGlobalsStay) {
  const std::string code = "local floor = math.floor\nprint(floor(x), pairs, type)\n";
  EXPECT_EQ(with_short_names(code), code);
  EXPECT_EQ(with_short_names("local function kind(type) return type .. kind end\n"),
            "local function a(type) return type .. a end\n");
}

TEST(ShortNames, AreNotNamesThatTheCodeHas) {
  EXPECT_EQ(with_short_names("local first, a, b = 1, 2, c\nreturn first\n"),
            "local d, a, b = 1, 2, c\nreturn d\n");
}

}  // namespace talus::short_names_test
