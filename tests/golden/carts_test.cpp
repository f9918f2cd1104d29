// Real carts, each as a cartridge and as a text project. Both hold the same content, so each form gives
// exactly the other.
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "formats/files/atomic_file.h"
#include "paths.h"

namespace talus::carts_test {

class CartsTest : public testing::TestWithParam<const char*> {
 protected:
  static std::string path(const std::string& extension) {
    return source_path("tests/golden/carts/") + GetParam() + "-data." + extension;
  }
  static Level load(const std::string& extension) { return load_level(path(extension)).value().level; }
  static std::string bytes(const std::string& extension) { return read_file(path(extension)).value(); }
  static WrittenLevel write(const Level& level, const std::string& extension) {
    const std::string name = "x." + extension;
    return format_for_file(name)->write(level, context_for_file(name)).value();
  }
};

TEST_P(CartsTest, CartridgeGivesTheTextProject) {
  const WrittenLevel text = write(load("tic"), "lua");
  EXPECT_EQ(text.bytes, bytes("lua"));
  EXPECT_TRUE(text.dropped.empty());
}

TEST_P(CartsTest, TextProjectGivesTheCartridge) {
  const WrittenLevel cart = write(load("lua"), "tic");
  EXPECT_EQ(cart.bytes, bytes("tic"));
  EXPECT_TRUE(cart.dropped.empty());
}

TEST_P(CartsTest, UntouchedFilesKeepEveryByte) {
  for (const char* extension : {"tic", "lua"})
    EXPECT_EQ(write(load(extension), extension).bytes, bytes(extension));
}

TEST_P(CartsTest, NativeLevelsLoseNoByte) {
  for (const char* extension : {"tic", "lua"}) {
    const Level level = load(extension);
    const WrittenLevel native = write(level, "talus.json");
    const auto again = read_level(native.bytes, {"json"});
    ASSERT_TRUE(again) << to_string(again.error(), "native");
    EXPECT_EQ(again->level, level);
    EXPECT_EQ(write(again->level, extension).bytes, bytes(extension));
    EXPECT_TRUE(native.dropped.empty());
    EXPECT_EQ(write(again->level, "talus.json").bytes, native.bytes);
  }
}

TEST_P(CartsTest, HaveTheExactSolver) {
  for (const char* extension : {"tic", "lua"}) EXPECT_EQ(load(extension).tuning.solver, SolverKind::exact);
}

TEST_P(CartsTest, BothFormsShowTheSameLevel) {
  Level tic = load("tic"), text = load("lua");
  tic.cart = text.cart = nullptr;
  EXPECT_EQ(tic, text);
}

INSTANTIATE_TEST_SUITE_P(All, CartsTest, testing::Values("car", "quest", "tetris"));

}  // namespace talus::carts_test
