// The question about exports that came with a file, as the user sees it.

#include "harness.h"

namespace talus::allow_exports_test {

class UiAllowExports : public UiTest {
 protected:
  // Writes a level of somebody else into a folder of its own.
  std::string put_level(std::vector<ExportPreset> presets) {
    Level level = test_level();
    level.exports = std::move(presets);
    std::filesystem::create_directories(path("level"));
    EXPECT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
    return path("level/cave.talus.json");
  }
  void settle() {
    frames(3);
    ASSERT_TRUE(frames_until([&] { return !session().exporting().is_busy(); }));
    frames(3);
  }
  void paint_and_save() {
    session().apply(action::EditLevel{Edit{"Paint", {ColorChange{3, level().palette[3], Rgb{1, 2, 3}}}}});
    key(ctrl('s'));
    settle();
  }
  static ExportPreset preset(const std::string& exporter, const std::string& to) {
    return {.name = exporter, .exporter = exporter, .path = to, .on_save = true, .extra = ""};
  }
};

TEST_F(UiAllowExports, TheListOfFilesIsShownBeforeTheFirstSaveWritesThem) {
  start(put_level({preset("tmj", "export/cave.tmj"), preset("love", "export/game")}));
  paint_and_save();
  ASSERT_NE(find("question/allow"), nullptr);
  for (const char* name : {"export/game/level.lua", "export/game/main.lua", "export/cave.tmj"})
    EXPECT_NE(find(std::string("question/file/") + name), nullptr) << name;
  EXPECT_FALSE(std::filesystem::exists(path("level/export")));
  key(kKeyEnter);  // Enter is "Not now"
  settle();
  EXPECT_FALSE(session().question());
  EXPECT_FALSE(std::filesystem::exists(path("level/export")));
  key(ctrl_shift('w'));
  settle();
  click("question/allow");
  settle();
  EXPECT_TRUE(std::filesystem::exists(path("level/export/game/main.lua")));
  EXPECT_TRUE(std::filesystem::exists(path("level/export/cave.tmj")));
}

TEST_F(UiAllowExports, ALongListScrollsInASmallWindow) {
  std::vector<ExportPreset> presets;
  for (int i = 0; i < 100; ++i)
    presets.push_back(preset("csv", std::string(1000, 'x').substr(0, 200) + "\n" + std::to_string(i)));
  start(put_level(presets), 1152, 700);
  paint_and_save();
  const Widget* allow = find("question/allow");
  ASSERT_NE(allow, nullptr);
  EXPECT_LT(allow->max.y, 700);
  EXPECT_LT(allow->max.x, 1152);
  key(kKeyEscape);
  settle();
  EXPECT_FALSE(session().question());
}

TEST_F(UiAllowExports, APlaceOutsideIsShownAndAllowedInTheWindow) {
  start(put_level({preset("tmj", "../game/cave.tmj")}));
  key(ctrl_shift('x'));
  settle();
  ASSERT_NE(find("export/error"), nullptr);
  ASSERT_NE(find("export/not_allowed"), nullptr);
  click("export/allow_place");
  settle();
  EXPECT_EQ(find("export/error"), nullptr);
  click("export/export");
  settle();
  EXPECT_FALSE(std::filesystem::exists(path("game")));
  click("question/allow");
  settle();
  EXPECT_TRUE(std::filesystem::exists(path("game/cave.tmj")));
  EXPECT_EQ(find("export/not_allowed"), nullptr);
}

}  // namespace talus::allow_exports_test
