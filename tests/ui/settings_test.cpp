// Settings, keys, layouts, the command palette and other programs, by hand.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "harness.h"
#include "panels/commands/commands.h"
#include "panels/window/programs.h"
#include "platform/picture.h"

namespace talus::settings_test {

constexpr KeyChord kEnterKey{'\r'}, kEscKey{kKeyEscape};

class UiSettings : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  void open_settings() {
    key(ctrl(','));
    frames(3);
    ASSERT_NE(find("settings/light"), nullptr);
  }
  void open_keys(const std::string& letters) {
    key(ctrl_shift('k'));
    frames(3);
    type(letters);
    frames(2);
  }
  const Preferences& preferences() { return app().ui().view.preferences; }
  void start_again() {
    stop();
    start(path("level.talus.json"));
  }
};

// A setting that the program takes and does not store again, or the other way round, comes back as it was
// first.
TEST_F(UiSettings, EverySettingIsTakenAndStoredAgain) {
  using nlohmann::json;
  const std::string file = path("config/settings.json");
  stop();
  const json standard = json::parse(bytes_of(file));
  json unusual_overlays = json::array(), programs = json::object();
  for (const Overlay* overlay : all_overlays())
    if (!overlay->is_default) unusual_overlays.push_back(overlay->key);
  for (const ProgramInfo& info : program_infos()) programs[std::string(info.key)] = "true {file}";
  json layout = standard["layout"];
  for (json& share : layout) share = share.get<double>() + 0.03125;
  json changed = {
      {"width", 1200},
      {"height", 700},
      {"layout", layout},
      {"canvas", "map"},
      {"ui_scale", 1.25},
      {"overlays", unusual_overlays},
      {"recent_files", {path("level.talus.json"), path("other.tic")}},
      {"kept_folders", {path("levels")}},
      {"tabs", {"color", "why", "history", "breakpoints"}},
      {"breakpoints",
       {{{"condition", "vx > 3"}, {"body", 2}, {"count", 4}, {"each_frame", true}, {"enabled", false}}}},
      {"plots", {"vx"}},
      {"overlay_palette", "colour_blind"},
      {"tour_step", 3},
      {"moved_tabs", {{{"panel", "reach"}, {"place", "dock"}}}},
      {"layouts",
       {{{"name", "wide"},
         {"sizes", layout},
         {"canvas", "both"},
         {"left_column", false},
         {"right_column", true},
         {"right_column_below", false},
         {"debugger", true},
         {"tabs", {"why"}},
         {"moved_tabs", {{{"panel", "why"}, {"place", "closed"}}}}}}},
      {"preferences",
       {{"theme", "light"},
        {"font_size", 16},
        {"plays_opened", false},
        {"starts_with", "last_level"},
        {"middle_picks", true},
        {"gamepad",
         {{"left", {"x", ""}},
          {"right", {"y", "b"}},
          {"jump", {"", "a"}},
          {"stick", false},
          {"dead_zone", 0.5}}},
        {"keys", {{"canvas/grid", {"Ctrl+Shift+J", ""}}}},
        {"programs", programs}}}};
  for (const auto& [key, value] : standard.items()) {
    if (value.is_boolean()) changed[key] = !value.get<bool>();
    ASSERT_TRUE(changed.contains(key)) << "give " << key << " a value here that it does not have at first";
    EXPECT_NE(changed[key], value) << key;
  }
  std::ofstream(file) << changed.dump();
  start(path("level.talus.json"), 1200, 700);
  stop();
  json stored = json::parse(bytes_of(file));
  for (json* list : {&stored["tabs"], &changed["tabs"]})
    std::sort(list->begin(), list->end());  // any order will do
  for (const auto& [key, value] : standard.items()) EXPECT_EQ(stored[key], changed[key]) << key;
}

TEST_F(UiSettings, TheLightThemeIsLightAndStored) {
  const auto brightness = [&] {
    const ImVec4 c = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    return c.x + c.y + c.z;
  };
  const float dark = brightness();
  open_settings();
  click("settings/light");
  frames(2);
  EXPECT_GT(brightness(), dark + 2);
  start_again();
  EXPECT_GT(brightness(), dark + 2);
  key(ctrl_shift('h'));
  frames(2);
  EXPECT_EQ(brightness(), dark);
}

TEST_F(UiSettings, SizesChangeAtOnceAndAreStored) {
  const float font = ImGui::GetFontSize();
  open_settings();
  click("settings/scale");
  frames(2);
  click("settings/scale/125");
  frames(3);
  EXPECT_EQ(app().ui().scale, 1.25f);
  EXPECT_EQ(ImGui::GetFontSize(), std::round(font * 1.25f));
  start_again();
  EXPECT_EQ(app().ui().scale, 1.25f);
}

TEST_F(UiSettings, SizesStayWithinTheWindow) {
  open_settings();
  click("settings/scale");
  frames(2);
  click("settings/scale/200");
  frames(3);
  EXPECT_EQ(app().ui().scale, 1.25f) << "in 1280x720 px";
  start(save_test_level("level.talus.json"), 2560, 1440);
  frames(3);
  EXPECT_EQ(app().ui().scale, 2);
}

TEST_F(UiSettings, ColoursForColourBlindPeopleAreStored) {
  open_settings();
  click("settings/safe_colours");
  EXPECT_EQ(session().choices().overlay_palette, OverlayPalette::colour_blind);
  start_again();
  EXPECT_EQ(session().choices().overlay_palette, OverlayPalette::colour_blind);
}

TEST_F(UiSettings, AProgramsCommandIsTyped) {
  open_settings();
  click("settings/tic80");
  key(ctrl('a'));
  type("true {file}");
  key(kEnterKey);
  frames(2);
  EXPECT_EQ(preferences().programs[0], "true {file}");
  key(ctrl(','));
  frames(2);
  key(ctrl_shift('t'));
  frames(2);
  ASSERT_TRUE(session().message());
  EXPECT_FALSE(session().message()->is_error) << session().message()->text;
  EXPECT_NE(session().message()->text.find("TIC-80"), std::string::npos);
  start_again();
  EXPECT_EQ(preferences().programs[0], "true {file}");
  open_settings();
  click("settings/tic80_reset");
  EXPECT_EQ(preferences().programs[0], "tic80 {file}");
}

TEST_F(UiSettings, AMissingProgramIsReportedInAMessage) {
  app().ui().view.preferences.programs[0] = "no-such-program-anywhere {file}";
  click("menu/File");
  frames(2);
  click("menu/program/tic80");
  frames(2);
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_NE(session().message()->text.find("cannot be started"), std::string::npos);
}

TEST_F(UiSettings, AKeyIsChangedAndStored) {
  open_keys("grid");
  click("keys/first/canvas/grid");
  frames(2);
  key(ctrl_shift('j'));
  frames(2);
  EXPECT_FALSE(app().ui().view.commands.key_capture);
  key(kEscKey);
  frames(3);
  const bool grid = session().choices().grid;
  key(KeyChord{'`'});
  EXPECT_EQ(session().choices().grid, grid) << "the old key does nothing";
  key(ctrl_shift('j'));
  EXPECT_EQ(session().choices().grid, !grid);
  EXPECT_EQ(keys_of("canvas/grid"_command, app().ui()), "Ctrl+Shift+J");
  start_again();
  key(ctrl_shift('j'));
  EXPECT_EQ(session().choices().grid, grid);
  open_keys("grid");
  click("keys/reset/canvas/grid");
  EXPECT_TRUE(preferences().keys.changed.empty());
}

TEST_F(UiSettings, AKeyInUseIsReassignedOnlyOnRequest) {
  open_keys("grid");
  click("keys/first/canvas/grid");
  key(ctrl('s'));
  frames(2);
  ASSERT_NE(find("keys/take"), nullptr);
  click("keys/cancel");
  frames(2);
  EXPECT_TRUE(preferences().keys.changed.empty());
  click("keys/first/canvas/grid");
  key(ctrl('s'));
  frames(2);
  click("keys/take");
  frames(2);
  EXPECT_EQ(keys_of("canvas/grid"_command, app().ui()), "Ctrl+S");
  EXPECT_EQ(keys_of("file/save"_command, app().ui()), "");
  click("keys/reset_all");
  click("keys/reset_all");
  EXPECT_EQ(keys_of("file/save"_command, app().ui()), "Ctrl+S");
}

TEST_F(UiSettings, EscapeStopsWaitingForAKeyAndThenCloses) {
  open_keys("grid");
  click("keys/first/canvas/grid");
  frames(2);
  ASSERT_TRUE(app().ui().view.commands.key_capture);
  key(kEscKey);
  frames(3);
  EXPECT_FALSE(app().ui().view.commands.key_capture);
  EXPECT_TRUE(app().ui().view.commands.keys_open);
  key(kEscKey);
  frames(3);
  EXPECT_FALSE(app().ui().view.commands.keys_open);
}

TEST_F(UiSettings, ReadyLayoutsByKey) {
  const View& view = app().ui().view;
  key(ctrl_shift('3'));
  frames(3);
  EXPECT_EQ(view.canvas.mode, CanvasMode::play);
  EXPECT_TRUE(view.window.dock_open);
  key(ctrl_shift('1'));
  frames(3);
  EXPECT_EQ(view.canvas.mode, CanvasMode::play);
  EXPECT_FALSE(view.window.dock_open);
  EXPECT_TRUE(view.window.left_open);
  key(ctrl_shift('2'));
  frames(3);
  EXPECT_FALSE(view.window.left_open);
  EXPECT_EQ(view.canvas.mode, CanvasMode::play);
  EXPECT_FALSE(view.window.dock_open);
  key(ctrl('0'));
  frames(3);
  EXPECT_EQ(view.window.layout, Layout());
}

TEST_F(UiSettings, ThePaletteFindsByAFewLettersAndRunsByEnter) {
  key(ctrl('p'));
  frames(3);
  type("scrbor");  // SCReen BORders
  ASSERT_NE(find("command_palette/canvas/borders"), nullptr);
  const bool borders = session().choices().screen_borders;
  key(kEnterKey);
  frames(3);
  EXPECT_EQ(session().choices().screen_borders, !borders);
  EXPECT_EQ(find("command_palette/text"), nullptr);
}

TEST_F(UiSettings, EnterRunsNoOtherCommandThanTheTypedOne) {
  key(ctrl('p'));
  frames(3);
  type("undo");
  ASSERT_FALSE(find("command_palette/edit/undo")->enabled);
  const Level before = level();
  key(kEnterKey);
  frames(3);
  EXPECT_NE(find("command_palette/text"), nullptr) << "the list stays open";
  EXPECT_EQ(level(), before);
  EXPECT_FALSE(session().question());
  key(SDLK_DOWN);
  key(kEnterKey);
  frames(3);
  EXPECT_EQ(find("command_palette/text"), nullptr) << "the next one was chosen by hand";
}

TEST_F(UiSettings, ThePaletteIsScrolledAndClickedByTheMouse) {
  click("menu/Help");
  frames(2);
  click("menu/help/commands");
  frames(3);
  ASSERT_NE(find("command_palette/file/new"), nullptr);
  const float top = find("command_palette/file/new")->min.y;
  move(centre("command_palette/file/save"));
  wheel(-3);
  frames(3);
  const Widget* first = find("command_palette/file/new");
  EXPECT_TRUE(first == nullptr || first->min.y < top) << "the chosen row does not hold the list";
  wheel(3);
  frames(3);
  click("command_palette/file/open");
  frames(3);
  EXPECT_EQ(find("command_palette/text"), nullptr);
  EXPECT_NE(find("files/name"), nullptr);
}

TEST_F(UiSettings, TheMouseAloneReachesEveryCommand) {
  start(path("level.talus.json"), 1280, 1440);
  app().ui().view.window.ui_scale = 1;  // so that every row of a menu is on the screen
  frames(2);
  click("menu/Help");
  frames(2);
  click("menu/all");
  frames(3);
  std::vector<std::string> groups;
  for (const Widget& widget : app().ui().widgets.all())
    if (widget.name.starts_with("menu/all/")) groups.push_back(widget.name);
  std::set<std::string> found;
  for (const std::string& group : groups) {
    const std::string prefix = group.substr(std::string("menu/all/").size()) + "/";
    for (std::string menu = group; find(menu) != nullptr; menu += "/more") {
      click(menu);
      frames(4);
      for (const Command& command : commands())
        if (command.id.starts_with(prefix) && find("menu/" + std::string(command.id)) != nullptr)
          found.insert(std::string(command.id));
    }
  }
  EXPECT_EQ(found.size(), commands().size());
}

TEST_F(UiSettings, WindowsAndDialogsAreWholeInTheSmallestWindow) {
  start(path("level.talus.json"), 1152, 700);
  const auto check = [&](std::string_view prefix, std::size_t least) {
    std::size_t count = 0;
    for (const Widget& w : app().ui().widgets.all()) {
      if (!w.name.starts_with(prefix)) continue;
      ++count;
      EXPECT_GE(w.min.x, w.clip_min.x) << w.name;
      EXPECT_LE(w.max.x, w.clip_max.x) << w.name;
      if (w.scrolls) continue;
      EXPECT_GE(w.min.y, w.clip_min.y) << w.name;
      EXPECT_LE(w.max.y, w.clip_max.y) << w.name;
    }
    EXPECT_GE(count, least) << prefix;
  };
  for (double size : {14.0, kMaxFontSize}) {
    app().ui().view.preferences.font_size = size;
    open_settings();
    check("settings/", 14);
    key(ctrl(','));
    open_keys("");
    check("keys/", 20);
    key(kEscKey);
    frames(3);
    EXPECT_FALSE(app().ui().view.commands.keys_open);
  }
}

TEST_F(UiSettings, TheTimesOfTheWindowAreShown) {
  key(ctrl_shift('u'));
  frames(3);
  ASSERT_NE(find("metrics/window"), nullptr);
  const FrameMetrics& metrics = app().ui().view.window.metrics;
  EXPECT_GT(metrics.median_ms(), 0);
  EXPECT_GE(metrics.max_ms(), metrics.median_ms());
  EXPECT_GT(metrics.last().vertices, 1000);
  EXPECT_GT(metrics.last().draw_calls, 5);
  frames(200);
  EXPECT_EQ(metrics.frames(), FrameMetrics::kFrames);
}

// 1,000 bodies with all overlays in 1920x1080 should take less than 4 ms. Slow machines and sanitizers get
// ten times that, which is still less than quadratic work takes.
TEST_F(UiSettings, AThousandBodiesWithAllOverlaysAreQuick) {
  Level crowd = test_level();
  crowd.map = TileMap(240, 136);
  for (int x = 0; x < 240; ++x) crowd.map.set({x, 135}, 1);
  for (int i = 0; i < 1000; ++i) crowd.map.set({(i % 100) * 2 + 1, (i / 100) * 8 + 2}, 2);
  ASSERT_TRUE(save_level(crowd, *find_format("native"), path("crowd.talus.json")));
  start(path("crowd.talus.json"), 1920, 1080);
  for (const Overlay* overlay : all_overlays()) session().apply(action::SetOverlay{overlay, true});
  key(ctrl('2'));
  for (int i = 0; i < 60; ++i) {
    session().apply(action::StepFrame{});
    frames(1);
  }
  app().ui().view.window.metrics.clear();
  for (int i = 0; i < 60; ++i) {
    session().apply(action::StepFrame{});
    frames(1);
  }
  EXPECT_EQ(session().state().bodies.size(), 1000u);
  EXPECT_LT(app().ui().view.window.metrics.median_ms(), 40);
}

TEST_F(UiSettings, TheSizeOfTextIsFoundByItsWords) {
  for (const char* typed : {"size of text", "larger text", "zoom text"}) {
    key(ctrl('p'));
    frames(3);
    type(typed);
    EXPECT_NE(find("command_palette/view/larger_text"), nullptr) << typed;
    key(kEscKey);
    frames(3);
  }
  key(ctrl('p'));
  frames(3);
  type("resize map");
  EXPECT_NE(find("command_palette/map/resize"), nullptr);
  key(kEscKey);
  frames(3);
  const float before = app().ui().scale;
  key(ctrl('p'));
  frames(3);
  type("larger text");
  key(kEnterKey);
  frames(4);
  EXPECT_GT(app().ui().view.window.ui_scale, before);
}

TEST_F(UiSettings, CommandsThatCannotRunComeLast) {
  key(ctrl('p'));
  frames(3);
  type("map");
  std::vector<const Widget*> rows;
  for (const Widget& widget : app().ui().widgets.all())
    if (widget.name.starts_with("command_palette/") && widget.name != "command_palette/text")
      rows.push_back(&widget);
  ASSERT_GT(rows.size(), 3u);
  EXPECT_TRUE(rows.front()->enabled);
}

TEST_F(UiSettings, ResettingTheLayoutRestoresThePixels) {
  app().ui().view.sprites.pixels.enlarged = true;
  frames(2);
  key(ctrl('0'));
  frames(2);
  EXPECT_FALSE(app().ui().view.sprites.pixels.enlarged);
}

TEST_F(UiSettings, NumbersOfTheTuningAreNotCutInANarrowColumn) {
  app().ui().view.window.layout.right = 0;
  app().ui().ask(request::ShowTab(panel_id::kTuning));
  frames(3);
  int seen = 0;
  for (const TuningField& field : tuning_fields()) {
    const Widget* widget = find("tuning/" + field.path());
    if (widget == nullptr) continue;  // it is further down
    ++seen;
    const std::string text = "0.025 " + std::string(field.unit);
    EXPECT_LE(size_of_text(text).x, widget->max.x - widget->min.x) << field.path();
    EXPECT_LE(widget->max.x, widget->clip_max.x) << field.path();
  }
  EXPECT_GT(seen, 3);
}

}  // namespace talus::settings_test
