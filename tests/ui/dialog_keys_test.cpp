// Dialogs, windows and panels without a mouse.
#include <imgui_internal.h>

#include <functional>
#include <map>

#include "formats/files/atomic_file.h"
#include "formats/pictures/png_sheet.h"
#include "harness.h"
#include "panels/commands/commands.h"

namespace talus::dialog_keys_test {

constexpr KeyChord kEscapeKey{kKeyEscape};
constexpr int kFiveSeconds = 5 * 60;  // frames

class UiDialogKeys : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  std::string level_file() const { return path("level.talus.json"); }
  void paint(Cell cell, int tile = 1) {
    click(on_sheet(tile));
    click(on_map(cell));
    ASSERT_EQ(tile_at(cell), tile);
  }
  void press_key(KeyChord chord, int times = 1) {
    for (int i = 0; i < times; ++i) key(chord);
    frames(2);
  }
  void press_letter(char letter) {
    push_typing(std::string(1, letter));
    frames(4);
  }
  // Quits with unsaved changes.
  void ask_to_quit() {
    paint({12, 9});
    press_key(ctrl('q'));
    frames(3);
    ASSERT_NE(find("question/save"), nullptr);
  }
  void crash_and_start() {
    frames(kFiveSeconds);
    stop();
    start(level_file());
    frames(3);
  }
  std::string focused() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return ImGui::GetIO().NavVisible ? std::to_string(context.NavId) : "";
  }
  void run_from_palette(const std::string& typed) {
    press_key(ctrl('p'));
    frames(3);
    type(typed);
    press_key({kKeyEnter});
    frames(6);
  }
  const View& view() { return app().ui().view; }
};

// A dialog that did not say so in time would lose keys that are pressed before it is drawn.
TEST_F(UiDialogKeys, EachDialogIsWantedInTheFrameThatOpensIt) {
  using Titles = std::vector<std::string>;
  const auto run = [&](CommandId id) {
    Actions actions;
    find_command(id).run(session(), actions, app().ui());
    session().apply(actions);
  };
  ASSERT_TRUE(write_file_atomic(path("tiles.png"), write_png_part(level(), PngPart::tiles)));
  paint({12, 9});
  const std::map<std::string, std::function<void()>> openers = {
      {"Find a command", [&] { run("help/commands"_command); }},
      {"Keys of the commands", [&] { run("edit/keys"_command); }},
      {"Size of the map", [&] { run("map/resize"_command); }},
      {"Background of the map", [&] { run("map/background"_command); }},
      {"Recover unsaved work", [&] { run("file/recover"_command); }},
      {"Unsaved changes", [&] { run("file/quit"_command); }},
      {"Import a picture", [&] { session().apply(action::OpenPng{path("tiles.png")}); }},
  };
  for (const auto& [title, open] : openers) {
    EXPECT_TRUE(app().ui().wanted_dialogs(session()).empty()) << title;
    open();
    EXPECT_EQ(app().ui().wanted_dialogs(session()), Titles{title});
    frames(3);
    const ImGuiWindow* shown = ImGui::GetTopMostPopupModal();
    ASSERT_NE(shown, nullptr) << title;
    EXPECT_EQ(shown->Name, title);
    press_key(kEscapeKey);
    frames(3);
  }
  push_stroke(ctrl('o'));
  push_typing("x");
  frames(6);
  EXPECT_EQ(app().ui().wanted_dialogs(session()), Titles{"Files"});
  EXPECT_EQ(tile_at({12, 9}), 1);
  press_key(kEscapeKey);
  EXPECT_TRUE(app().ui().wanted_dialogs(session()).empty());
}

TEST_F(UiDialogKeys, EnterPressesTheHighlightedAnswer) {
  ask_to_quit();
  EXPECT_NE(focused(), "") << "the control that has the keys is marked";
  press_key({kKeyEnter});
  EXPECT_TRUE(session().wants_quit());
  EXPECT_FALSE(session().modified()) << "saved";
}

TEST_F(UiDialogKeys, TabAndArrowsGoFromAnswerToAnswer) {
  for (const KeyChord there : {KeyChord{kKeyTab}, KeyChord{kKeyRight}}) {
    start(level_file());
    ask_to_quit();
    const std::string first = focused();
    press_key(there);
    EXPECT_NE(focused(), first);
    EXPECT_NE(focused(), "");
    press_key({' '});
    EXPECT_TRUE(session().wants_quit()) << to_string(there);
    EXPECT_TRUE(session().modified()) << "discarded";
  }
}

TEST_F(UiDialogKeys, ShiftTabAndLeftGoBack) {
  ask_to_quit();
  press_key({kKeyTab}, 2);
  hold_modifiers(shift(kKeyTab));
  press_key(shift(kKeyTab));
  hold_modifiers();
  press_key({kKeyLeft});
  press_key({kKeyEnter});
  EXPECT_TRUE(session().wants_quit());
  EXPECT_FALSE(session().modified()) << "the first answer again";
}

TEST_F(UiDialogKeys, UnderlinedLettersAnswer) {
  ask_to_quit();
  press_letter('c');
  EXPECT_FALSE(session().question());
  EXPECT_FALSE(session().wants_quit());
  press_key(ctrl('q'));
  frames(3);
  press_letter('d');
  EXPECT_TRUE(session().wants_quit());
  EXPECT_TRUE(session().modified());
}

TEST_F(UiDialogKeys, AHeldLetterIsNoAnswer) {
  paint({12, 9});
  Level other = test_level();
  other.map.set({12, 9}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  hold('t');
  frames(90);
  EXPECT_TRUE(session().question());
  let_go('t');
  EXPECT_TRUE(session().question());
}

TEST_F(UiDialogKeys, AFileChangedOutsideIsReadAgain) {
  paint({12, 9});
  Level other = test_level();
  other.map.set({1, 1}, 6);
  other.map.set({12, 9}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  frames(90);
  ASSERT_NE(find("question/reload"), nullptr);
  press_letter('t');
  EXPECT_EQ(tile_at({1, 1}), 6);
  EXPECT_EQ(tile_at({12, 9}), 6);
}

TEST_F(UiDialogKeys, TheDefaultAnswerIsHarmless) {
  for (int i = 0; i < 12; ++i) key(kKeyF10);
  press_key(alt(kKeyDelete));
  frames(3);
  ASSERT_NE(find("question/drop"), nullptr);
  press_key({kKeyEnter});
  EXPECT_FALSE(session().question());
  EXPECT_EQ(session().timeline().last_frame(), 12);
  press_key(alt(kKeyDelete));
  frames(3);
  press_letter('d');
  EXPECT_EQ(session().timeline().last_frame(), 0);
}

TEST_F(UiDialogKeys, EnterRecoversTheWork) {
  paint({12, 9});
  crash_and_start();
  ASSERT_NE(find("recovery/recover0"), nullptr);
  press_key({kKeyEnter});
  EXPECT_EQ(find("recovery/recover0"), nullptr);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiDialogKeys, ArrowsMoveInTheListOfRecoveredWork) {
  paint({12, 9});
  crash_and_start();
  press_key(kEscapeKey);
  session().apply(action::NewLevel{});
  frames(2);
  paint({3, 3});
  crash_and_start();
  ASSERT_NE(find("recovery/recover1"), nullptr);
  press_key({kKeyDown});
  press_letter('d');
  ASSERT_NE(find("recovery/discard1"), nullptr) << "it asks once more";
  press_key({kKeyRight});
  press_key({' '});
  EXPECT_EQ(find("recovery/recover1"), nullptr) << "the second one is discarded";
  ASSERT_NE(find("recovery/recover0"), nullptr);
  press_letter('l');
  EXPECT_EQ(find("recovery/recover0"), nullptr);
}

TEST_F(UiDialogKeys, TheMapIsResizedByKeys) {
  press_key(ctrl('e'));
  frames(3);
  press_key(ctrl('a'));
  type("40");
  press_key({kKeyTab});
  press_key(ctrl('a'));
  type("20");
  press_key({kKeyEnter});
  EXPECT_EQ(level().map.width(), 40);
  EXPECT_EQ(level().map.height(), 20);
  press_key(ctrl('e'));
  frames(3);
  press_key(ctrl('a'));
  type("4");
  press_key({kKeyEnter});
  EXPECT_EQ(focused().empty(), false) << "the way back has the keys";
  press_key({kKeyEnter});
  EXPECT_EQ(level().map.width(), 40) << "Enter loses nothing";
  ASSERT_NE(find("resize/apply"), nullptr);
  press_letter('r');
  press_letter('l');
  EXPECT_EQ(level().map.width(), 4);
}

TEST_F(UiDialogKeys, KeysAreChangedByKeys) {
  const auto keys_of_undo = [&] {
    return command_keys(find_command("edit/undo"_command), view().preferences.keys);
  };
  press_key(ctrl_shift('k'));
  frames(3);
  EXPECT_FALSE(find("keys/close")->scrolls) << "the dialog fits";
  type("undo");
  press_key({kKeyEnter});
  press_key(alt(kKeyF12));
  EXPECT_EQ(keys_of_undo()[0], alt(kKeyF12));
  press_key({kKeyRight});
  press_key({kKeyEnter});
  press_key(ctrl('s'));  // the key of Save
  ASSERT_NE(find("keys/take"), nullptr);
  EXPECT_FALSE(keys_of_undo()[1]);
  press_key({kKeyEnter});
  EXPECT_EQ(keys_of_undo()[1], ctrl('s'));
  press_key({kKeyDelete});
  EXPECT_FALSE(keys_of_undo()[1]);
  press_key(ctrl(kKeyDelete));
  EXPECT_EQ(keys_of_undo(), (CommandKeys{ctrl('z'), KeyChord{}}));
  press_key(kEscapeKey);
  EXPECT_FALSE(view().commands.keys_open);
}

TEST_F(UiDialogKeys, ArrowsChooseTheCommandWhoseKeyChanges) {
  press_key(ctrl_shift('k'));
  frames(3);
  press_key({kKeyDown});
  press_key({kKeyEnter});
  press_key({kKeyEnter});  // Enter is a key like any other here, and also a key of the cursor
  EXPECT_FALSE(command_keys(commands()[1], view().preferences.keys)[0] == KeyChord{kKeyEnter});
  ASSERT_NE(find("keys/take"), nullptr) << "it is asked about first";
  press_letter('t');
  EXPECT_EQ(command_keys(commands()[1], view().preferences.keys)[0], KeyChord{kKeyEnter});
}

TEST_F(UiDialogKeys, EscapeClosesAnErrorAndKeepsTheSelection) {
  click(on_map({2, 2}));
  press_key({kKeyF3});
  press_key(ctrl('a'));
  ASSERT_TRUE(session().choices().selection);
  session().apply(action::ShowMessage{"tic80 cannot be started.", true});
  frames(2);
  press_key(kEscapeKey);
  EXPECT_FALSE(session().message());
  EXPECT_TRUE(session().choices().selection);
  press_key(kEscapeKey);
  EXPECT_FALSE(session().choices().selection);
}

TEST_F(UiDialogKeys, SettingsAreChangedByKeys) {
  press_key(ctrl(','));
  frames(3);
  for (int i = 0; i < 8 && view().preferences.theme == ThemeKind::dark; ++i) {
    press_key({kKeyTab});
    press_key({' '});
  }
  EXPECT_EQ(view().preferences.theme, ThemeKind::light);
  press_key(kEscapeKey);
  EXPECT_FALSE(view().window.settings_open);
}

TEST_F(UiDialogKeys, ThePaletteSwitchesAFlag) {
  click(on_sheet(9));
  run_from_palette("switch flag 5");
  EXPECT_EQ(level().tile_flags(9), 1 << 5);
}

TEST_F(UiDialogKeys, ThePaletteGoesToTheByteOfFlags) {
  click(on_sheet(9));
  run_from_palette("type the flags");
  type("a5");
  press_key({kKeyEnter});
  EXPECT_EQ(level().tile_flags(9), 0xa5);
}

TEST_F(UiDialogKeys, ThePaletteNamesAFlag) {
  run_from_palette("name flag 6");
  type("ice");
  press_key({kKeyEnter});
  EXPECT_EQ(level().flag_names[6], "ice");
}

TEST_F(UiDialogKeys, ThePaletteGoesToTheColour) {
  click("palette/color3");
  run_from_palette("type the colour's green");
  press_key(ctrl('a'));
  type("77");
  press_key({kKeyEnter});
  EXPECT_EQ(level().palette[3].g, 77);
  run_from_palette("type the colour...");
  press_key(ctrl('a'));
  type("102030");
  press_key({kKeyEnter});
  EXPECT_EQ(level().palette[3], (Rgb{0x10, 0x20, 0x30}));
}

TEST_F(UiDialogKeys, ThePaletteNamesABody) {
  press_key({kKeyF3});
  click("map/body");
  click(on_canvas("map", {100, 60}));
  frames(2);
  click("map/first_body_player");
  ASSERT_EQ(level().spawns.size(), 1u);
  run_from_palette("spawn rename");
  type("hero");
  press_key({kKeyEnter});
  EXPECT_EQ(level().spawns[0].name, "hero");
}

TEST_F(UiDialogKeys, TheEnterThatOpensADialogIsNoAnswerToIt) {
  run_from_palette("export the tiles");
  ASSERT_NE(find("files/confirm"), nullptr) << "it asks for a name";
  EXPECT_FALSE(std::filesystem::exists(path("level-tiles.png")));
  press_key({kKeyEnter});
  EXPECT_TRUE(std::filesystem::exists(path("level-tiles.png")));
  EXPECT_EQ(find("files/confirm"), nullptr);
  const std::string before = bytes_of(level_file());
  paint({12, 9});
  run_from_palette("save as");
  ASSERT_NE(find("files/confirm"), nullptr);
  press_key({kKeyEnter});
  EXPECT_NE(find("files/confirm"), nullptr) << "it asks whether to replace the level";
  EXPECT_EQ(bytes_of(level_file()), before);
  press_letter('r');
  EXPECT_EQ(find("files/confirm"), nullptr);
  EXPECT_NE(bytes_of(level_file()), before);
}

TEST_F(UiDialogKeys, TheEnterThatOpensAListFromAMenuChoosesNothingInIt) {
  run_from_palette("menu help");
  for (int i = 0; i < 3; ++i) press_key({kKeyDown});
  press_key({kKeyEnter});
  EXPECT_TRUE(view().commands.palette_open) << "the fourth one finds commands";
  press_key(kEscapeKey);
  EXPECT_FALSE(view().commands.palette_open);
}

TEST_F(UiDialogKeys, TabsAreOpenedByNameAndUsedByKeys) {
  for (const char* tab : {"history", "brushes", "problems", "shape", "inspector", "tuning"}) {
    run_from_palette(std::string("tab ") + tab);
    EXPECT_NE(std::find(view().window.tabs.begin(), view().window.tabs.end(), tab), view().window.tabs.end())
        << tab;
    press_key(kEscapeKey);
  }
  click(on_sheet(9));
  run_from_palette("tab flags");
  EXPECT_TRUE(view().window.keys_in_panel);
  EXPECT_NE(focused(), "") << "the control that has the keys is marked";
  press_key({kKeyDown});
  press_key({kKeyLeft}, 3);
  press_key({' '});
  EXPECT_EQ(level().tile_flags(9), 1) << "the first lamp is switched";
  press_key({kKeyDown});
  press_key({kKeyEnter});
  EXPECT_EQ(level().tile_flags(9), 3);
  press_key(kEscapeKey);
  EXPECT_FALSE(view().window.keys_in_panel);
}

TEST_F(UiDialogKeys, MenusAreOpenedByNameAndWalkedByArrows) {
  run_from_palette("menu file");
  EXPECT_NE(find("menu/file/new"), nullptr);
  press_key({kKeyDown}, 2);
  press_key({kKeyEnter});
  frames(3);
  EXPECT_NE(find("files/name"), nullptr) << "the third one opens a file";
  press_key({kKeyTab}, 2);
  press_key({kKeyEnter});
  EXPECT_EQ(find("files/name"), nullptr) << "Cancel has the keys";
}

}  // namespace talus::dialog_keys_test
