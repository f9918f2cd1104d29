// The export window: presets, the files that they would write, and writing them.
#include <imgui_internal.h>

#include "formats/files/atomic_file.h"
#include "harness.h"
#include "held_reading.h"
#include "platform/asset_path.h"

namespace talus::export_panel_test {

constexpr KeyChord kReturnKey{'\r'};

class UiExport : public UiTest {
 protected:
  const Exporting& exporting() { return session().exporting(); }
  // Lets frames pass until exports and previews are done and their results are drawn.
  void settle() {
    frames(3);
    ASSERT_TRUE(frames_until([&] { return !exporting().is_busy(); }));
    frames(3);
  }
  void open_window() {
    key(ctrl_shift('x'));
    settle();
    ASSERT_NE(find("export/window"), nullptr);
  }
  void choose_target(const std::string& letters, const std::string& id) {
    click("export/target");
    frames(3);
    type(letters);
    frames(2);
    ASSERT_NE(find("export/target/" + id), nullptr) << letters;
    click("export/target/" + id);
    settle();
  }
  // Replaces the text of a field, and leaves the field.
  void fill(const std::string& field, const std::string& text) {
    click(field);
    frames(2);
    key(ctrl('a'));
    type(text);
    key(kReturnKey);
    settle();
  }
  const ExportPreset& preset(std::size_t i) { return level().exports.at(i); }
  const ExportOutcome& shown() { return exporting().preview().value().outcome; }
  std::string message() { return session().message() ? session().message()->text : ""; }
};

TEST_F(UiExport, APresetIsAddedShownAndWritten) {
  start();
  open_window();
  EXPECT_EQ(find("export/export"), nullptr) << "there is nothing to export yet";
  click("export/add");
  settle();
  ASSERT_EQ(level().exports.size(), 1u);
  choose_target("tic-80 cart", "tic");
  EXPECT_EQ(preset(0).exporter, "tic");
  EXPECT_EQ(preset(0).name, "tic");
  EXPECT_EQ(preset(0).path, "export/level.tic");
  fill("export/name", "cart");
  EXPECT_EQ(preset(0).name, "cart");
  fill("export/path", "out/game.tic");
  EXPECT_EQ(preset(0).path, "out/game.tic");

  ASSERT_EQ(shown().files.size(), 2u) << "the cart, and what it cannot hold";
  const std::size_t size = shown().files[0].size;
  EXPECT_EQ(shown().files[0].place, PlannedFile::Place::empty);
  ASSERT_NE(find("export/file/game.tic"), nullptr);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
  click("export/export");
  settle();
  EXPECT_EQ(std::filesystem::file_size(path("out/game.tic")), size);
  EXPECT_EQ(message().substr(0, 39), "Exported cart: 2 files to out/game.tic.");
  click("message/copy_place");
  EXPECT_EQ(ImGui::GetClipboardText(), path("out/game.tic"));
  EXPECT_EQ(shown().files[0].place, PlannedFile::Place::same);
}

TEST_F(UiExport, TwoClicksExportAndAskNothing) {
  start();
  for (int i = 0; i < 2; ++i) {
    click("menu/File");
    frames(2);
    move(centre("menu/export_as"));
    ASSERT_TRUE(frames_until([&] { return find("menu/export_as/tmj") != nullptr; }));
    click("menu/export_as/tmj");
    settle();
    EXPECT_FALSE(session().question());
    ASSERT_EQ(level().exports.size(), 1u) << "the second time it is the same preset";
    EXPECT_EQ(preset(0).path, "export/level.tmj");
    EXPECT_TRUE(std::filesystem::exists(path("export/level.tmj"))) << message();
  }
  key(ctrl('z'));
  EXPECT_TRUE(level().exports.empty());
}

TEST_F(UiExport, TheWindowOffersATargetInAClick) {
  start();
  open_window();
  click("export/first/tmj");
  settle();
  ASSERT_EQ(level().exports.size(), 1u);
  EXPECT_EQ(preset(0).exporter, "tmj");
  EXPECT_TRUE(std::filesystem::exists(path(preset(0).path)));
  EXPECT_NE(find("export/export"), nullptr) << "it can be exported again";
}

TEST_F(UiExport, ALevelWithoutAFileIsSavedFirst) {
  start("");
  const auto export_as_map = [this] {
    click("menu/File");
    frames(2);
    move(centre("menu/export_as"));
    ASSERT_TRUE(frames_until([&] { return find("menu/export_as/tmj") != nullptr; }));
    click("menu/export_as/tmj");
    frames(3);
  };
  export_as_map();
  ASSERT_TRUE(session().wants_save_as());
  session().apply(action::CancelSaveAs{});
  settle();
  EXPECT_FALSE(std::filesystem::exists(path("export")));
  export_as_map();
  ASSERT_TRUE(session().wants_save_as());
  session().apply(action::SaveFileAs{path("mine.talus.json")});
  settle();
  EXPECT_TRUE(std::filesystem::exists(path(preset(0).path))) << message();
}

TEST_F(UiExport, AFolderIsWrittenAsPreviewed) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("love", "love");
  const std::vector<PlannedFile> files = shown().files;
  ASSERT_GE(files.size(), 5u);
  click("export/all");
  settle();
  for (const PlannedFile& file : files)
    EXPECT_EQ(std::filesystem::file_size(file.path), file.size) << file.name;
  // The level changes again, and the key exports it: nothing is asked about files that an export wrote.
  session().apply(action::EditLevel{Edit{"Paint", {ColorChange{3, level().palette[3], Rgb{1, 2, 3}}}}});
  key(ctrl_shift('w'));
  settle();
  EXPECT_FALSE(session().question());
  EXPECT_EQ(message().substr(0, 9), "Exported ");
}

TEST_F(UiExport, ThePreviewFollowsTheLevel) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("talus level", "native");
  const std::size_t before = shown().files[0].size;
  Edit edit{"Paint", {}};
  for (int x = 0; x < 20; ++x) edit.changes.emplace_back(CellChange{{x, 2}, tile_at({x, 2}), 7});
  session().apply(action::EditLevel{edit});
  settle();
  EXPECT_NE(shown().files[0].size, before);
}

TEST_F(UiExport, EditsOfPresetsCanBeUndone) {
  start();
  open_window();
  click("export/add");
  settle();
  click("export/duplicate");
  settle();
  ASSERT_EQ(level().exports.size(), 2u);
  EXPECT_EQ(app().ui().view.files.exports.preset, 1u) << "the new one is chosen";
  EXPECT_EQ(preset(1).name, preset(0).name + " 2");
  click("export/on_save");
  settle();
  EXPECT_TRUE(preset(1).on_save);
  click("export/preset0");
  click("export/remove");
  settle();
  ASSERT_EQ(level().exports.size(), 1u);
  EXPECT_TRUE(preset(0).on_save);
  key(ctrl('z'));
  ASSERT_EQ(level().exports.size(), 2u);
  key(ctrl('z'));
  EXPECT_FALSE(preset(1).on_save);
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_TRUE(level().exports.empty());
  settle();
}

TEST_F(UiExport, AnUnwritablePathIsReportedUnderIt) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("tic-80 cart", "tic");
  EXPECT_EQ(find("export/error"), nullptr);
  fill("export/path", "level.talus.json/game.tic");
  ASSERT_NE(find("export/error"), nullptr);
  EXPECT_EQ(shown().problem->field, ExportProblem::Field::path);
  EXPECT_GT(find("export/error")->min.y, find("export/path")->max.y);
  EXPECT_FALSE(find("export/export")->enabled);
  fill("export/path", "game.zip");
  ASSERT_NE(find("export/error"), nullptr);
  EXPECT_EQ(shown().problem->error.message.substr(0, 23), "game.zip is not a name ");
  fill("export/path", "game.tic");
  EXPECT_EQ(find("export/error"), nullptr);
  EXPECT_TRUE(find("export/export")->enabled);
}

TEST_F(UiExport, PartsAreOfferedForTargetsWithTheRuntime) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("tic-80 cart", "tic");
  EXPECT_EQ(find("export/parts"), nullptr);
  choose_target("lua runtime", "lua-runtime");
  ASSERT_NE(find("export/parts"), nullptr);
  const std::size_t size = shown().files[0].size;
  fill("export/parts", "players, mouse");
  EXPECT_EQ(preset(0).parts, "players, mouse");
  EXPECT_GT(shown().files[0].size, size + 2'000);
  fill("export/parts", "plyers");
  ASSERT_NE(find("export/error"), nullptr);
  EXPECT_EQ(shown().problem->error.message.substr(0, 27), "\"plyers\" is not a part of t");
  EXPECT_FALSE(find("export/export")->enabled);
  key(ctrl('z'));
  settle();
  EXPECT_EQ(preset(0).parts, "players, mouse");
}

TEST_F(UiExport, AForeignFileIsAskedAbout) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("tic-80 cart", "tic");
  fill("export/path", "game.tic");
  (void)write_file_atomic(path("game.tic"), "mine");
  click("export/all");
  settle();
  ASSERT_NE(find("question/replace"), nullptr);
  click("question/cancel");
  settle();
  EXPECT_EQ(bytes_of(path("game.tic")), "mine");
  click("export/export");
  settle();
  click("question/replace");
  settle();
  EXPECT_EQ(find("question/replace"), nullptr);
  EXPECT_NE(bytes_of(path("game.tic")), "mine");
}

TEST_F(UiExport, BrowsingChoosesAFolder) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("love", "love");
  click("export/browse");
  frames(3);
  ASSERT_NE(find("files/name"), nullptr);
  key(ctrl('a'));
  type("mine");
  click("files/confirm");
  settle();
  EXPECT_EQ(find("files/name"), nullptr);
  EXPECT_EQ(preset(0).path, "mine");
  EXPECT_EQ(shown().output, path("mine"));
}

TEST_F(UiExport, WithoutAFileItSaysWhatToDo) {
  start("");
  open_window();
  click("export/add");
  settle();
  ASSERT_NE(find("export/error"), nullptr);
  EXPECT_FALSE(shown().files.empty()) << "their sizes are known all the same";
  click("export/save");
  frames(3);
  EXPECT_TRUE(session().wants_save_as());
}

TEST_F(UiExport, ALongPreviewShowsItsShareAndCanBeCancelled) {
  Level level = test_level();
  level.exports.push_back({"game", "love", "out/game", "", false, ""});
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
  start(path("level.talus.json"));
  std::optional<HeldReading> held(asset_path("templates/love/main.lua"));
  key(ctrl_shift('x'));
  ASSERT_TRUE(frames_until([&] { return find("export/preview_progress") != nullptr; }));
  EXPECT_FALSE(find("export/export")->enabled) << "whether it works is not known yet";
  click("export/cancel");
  frames(1);
  EXPECT_EQ(find("export/preview_progress"), nullptr) << "at once";
  held.reset();
  settle();
  EXPECT_FALSE(exporting().preview());
  ASSERT_NE(find("export/preview_again"), nullptr);
  EXPECT_TRUE(find("export/export")->enabled) << "it needs no preview";
  held.emplace(asset_path("templates/love/main.lua"));
  click("export/preview_again");
  frames(2);
  EXPECT_TRUE(exporting().previewing());
  session().apply(action::CancelExport{});
  held.reset();
  settle();
}

TEST_F(UiExport, TheMessageAndTheTooltipsOfButtonsCoverNoControl) {
  for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{2560, 1440}}) {
    start("", width, height);
    open_window();
    click("export/add");
    settle();
    session().apply(action::ShowMessage{"Exported game: 5 files to a folder with quite a long name."});
    frames(3);
    const Widget window = *find("export/window"), message = *find("message/dismiss");
    const bool beside = message.min.x > window.max.x || message.max.x < window.min.x ||
                        message.min.y > window.max.y || message.max.y < window.min.y;
    EXPECT_TRUE(beside) << width;
    EXPECT_LE(message.max.y, static_cast<float>(height));
    const float buttons = find("export/add")->min.y;
    move({2, 2});  // what was pressed explains itself again when the mouse comes back
    frames(2);
    for (const char* name : {"export/add", "export/remove", "export/all"}) {
      move(centre(name));
      frames(60);
      const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
      ASSERT_TRUE(tooltip != nullptr && tooltip->Active) << name;
      EXPECT_LE(tooltip->Rect().Max.y, buttons) << name;
    }
  }
}

TEST_F(UiExport, ALongExportCanBeCancelled) {
  Level large = test_level();
  large.map = TileMap(1024, 1024);
  for (TileNumber& cell : large.map.cells().tiles()) cell = 200;  // much to write, but no ground
  for (std::size_t i = 0; i < kMaxExports; ++i)
    large.exports.push_back({"copy", "native", "out/" + std::to_string(i) + ".talus.json", "", false, ""});
  ASSERT_TRUE(save_level(large, *find_format("native"), path("large.talus.json")));
  start(path("large.talus.json"));
  session().apply(action::RunExports{});
  key(ctrl_shift('x'));
  frames(1);
  ASSERT_NE(find("export/progress"), nullptr);
  click("export/cancel");
  frames(1);
  EXPECT_EQ(find("export/progress"), nullptr) << "at once";
  while (session().message() == std::nullopt) frames(1);
  EXPECT_EQ(message(), "The export was cancelled: nothing was written.");
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(UiExport, ProposedPathsDoNotClash) {
  start();
  open_window();
  const std::pair<const char*, const char*> targets[] = {
      {"love", "love"},     {"tiled map, json", "tmj"},    {"simple tiled", "sti"},
      {"lua table", "lua"}, {"picture of the map", "png"}, {"picture of the tiles", "tiles-png"}};
  for (const auto& [letters, id] : targets) {
    click("export/add");
    settle();
    choose_target(letters, id);
  }
  click("export/add");
  settle();
  ASSERT_EQ(level().exports.size(), 7u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(preset(i).name, targets[i].second);
  EXPECT_EQ(preset(6).path, "export/love-2");
  EXPECT_EQ(preset(2).path, "export/level-sti.lua");
  click("export/all");
  settle();
  for (const ExportOutcome& outcome : exporting().last_run()) EXPECT_TRUE(outcome.written) << outcome.output;
  EXPECT_EQ(bytes_of(path("export/level.lua")).substr(0, 28), "-- A level exported by Talus");
}

TEST_F(UiExport, AClashIsReportedUnderThePath) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("lua table", "lua");
  click("export/add");
  settle();
  choose_target("simple tiled", "sti");
  EXPECT_EQ(find("export/error"), nullptr);
  fill("export/path", "export/level.lua");
  ASSERT_NE(find("export/error"), nullptr);
  EXPECT_EQ(
      shown().problem->error.message,
      "the presets \"lua\" and \"sti\" would both write export/level.lua: give one of them another path");
  EXPECT_FALSE(find("export/export")->enabled);
  click("export/preset0");
  settle();
  EXPECT_NE(find("export/error"), nullptr) << "it is the other one's, too";
  fill("export/path", "export/data.lua");
  EXPECT_EQ(find("export/error"), nullptr);
}

TEST_F(UiExport, AChangedStarterIsShownAsKept) {
  start();
  open_window();
  click("export/add");
  settle();
  choose_target("game for l", "love");
  click("export/export");
  settle();
  ASSERT_TRUE(write_file_atomic(path("export/love/main.lua"), "mine"));
  session().apply(action::EditLevel{Edit{"Paint", {ColorChange{3, level().palette[3], Rgb{1, 2, 3}}}}});
  settle();
  ASSERT_EQ(shown().kept.size(), 1u);
  ASSERT_NE(find("export/file/main.lua"), nullptr);
  click("export/export");
  settle();
  EXPECT_EQ(find("question/replace"), nullptr);
  EXPECT_EQ(bytes_of(path("export/love/main.lua")), "mine");
  EXPECT_NE(message().find("Kept main.lua, which is yours now."), std::string::npos) << message();
}

TEST_F(UiExport, NamesHaveMoreThanLatin) {
  start();
  const ImFont& font = *ImGui::GetFont();
  for (const ImWchar letter :
       std::initializer_list<ImWchar>{0x2013, 0x201e, 0x17e, 0x3bb, 0x436})  // – „ ž λ ж
    EXPECT_NE(font.FindGlyphNoFallback(letter), nullptr) << letter;
}

}  // namespace talus::export_panel_test
