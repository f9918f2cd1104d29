// Keys that the user has chosen, times of frames, and how preferences are written.
#include "panels/preferences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "folder_test.h"
#include "overlay/overlay_table.h"
#include "panels/commands/key_conflicts.h"
#include "panels/window/panel_list.h"
#include "platform/former_names.h"
#include "platform/preferences_fields.h"
#include "platform/settings.h"

namespace talus::preferences_test {

TEST(KeyText, SurvivesWritingAndReading) {
  for (const Command& command : commands()) {
    for (KeyChord chord : {command.key, command.other_key})
      EXPECT_EQ(parse_chord(to_string(chord)), chord) << to_string(chord);
  }
  for (KeyChord chord : {ctrl('+'), shift('+'), KeyChord{'+'}, KeyChord{}, ctrl_shift(' '), alt(kKeyF12)})
    EXPECT_EQ(parse_chord(to_string(chord)), chord) << to_string(chord);
  for (const char* text : {"Ctrl+", "Shift+Nothing", "F13", "Strg+A", "ab"})
    EXPECT_FALSE(parse_chord(text)) << text;
}

TEST(KeyBindings, ANewBindingReplacesTheOldOneOfTheKey) {
  KeyBindings bindings;
  const Command &save = find_command("file/save"_command), &grid = find_command("canvas/grid"_command);
  ASSERT_TRUE(bindings.changed.empty());
  EXPECT_EQ(command_with_key(ctrl('s'), grid, bindings), &save);
  EXPECT_EQ(command_with_key(ctrl('s'), save, bindings), nullptr);
  bind_key(grid, 1, ctrl('s'), bindings);
  EXPECT_EQ(command_keys(save, bindings), CommandKeys{});
  EXPECT_EQ(command_keys(grid, bindings), (CommandKeys{KeyChord{'`'}, ctrl('s')}));
  reset_keys(save, bindings);
  EXPECT_EQ(command_keys(save, bindings), (CommandKeys{ctrl('s'), KeyChord{}}));
  EXPECT_EQ(command_keys(grid, bindings), (CommandKeys{KeyChord{'`'}, KeyChord{}}));
  EXPECT_TRUE(bindings.changed.empty()) << "a key that is reset does not count as changed";
}

TEST(KeyBindings, EachSideOfTheWindowHasItsOwnKeys) {
  KeyBindings bindings;
  const Command &pencil = find_command("pixels/pencil"_command), &stamp = find_command("map/stamp"_command);
  ASSERT_EQ(pencil.key, stamp.key);
  EXPECT_EQ(command_with_key(pencil.key, stamp, bindings), nullptr);
  bind_key(find_command("canvas/grid"_command), 0, pencil.key, bindings);
  EXPECT_FALSE(command_keys(pencil, bindings)[0]);
  EXPECT_FALSE(command_keys(stamp, bindings)[0]) << "a key that works everywhere takes it from both";
}

Preferences read_preferences(const nlohmann::json& object) {
  Preferences preferences;
  read_fields(preferences_fields(), object, preferences);
  return preferences;
}

TEST(PreferencesJson, IsReadAsItWasWritten) {
  Preferences preferences;
  preferences.theme = ThemeKind::light;
  preferences.font_size = 16;
  preferences.plays_opened = false;
  preferences.middle_picks = true;
  preferences.programs[1] = "\"/opt/my love\" {folder}";
  preferences.keys.changed["file/save"] = {ctrl_shift('x'), KeyChord{}};
  preferences.keys.changed["no/such/command"] = {KeyChord{}, alt(kKeyF12)};
  EXPECT_EQ(read_preferences(written_fields(preferences_fields(), preferences)), preferences);
  EXPECT_EQ(read_preferences(written_fields(preferences_fields(), Preferences())), Preferences());
}

TEST(PreferencesJson, WrongValuesGetTheirDefaults) {
  EXPECT_EQ(read_preferences(nlohmann::json::parse(
                R"({"theme": 3, "font_size": 99, "keys": {"a": 1}, "programs": {"tic80": 4, "x": "y"}})")),
            Preferences());
  const Preferences odd =
      read_preferences(nlohmann::json::parse(R"({"keys": {"a": ["Ctrl+A", "What+B", "Ctrl+C"]}})"));
  EXPECT_EQ(odd.keys.changed.at("a"), (CommandKeys{ctrl('a'), KeyChord{}}));
}

TEST(FormerNames, LeadToNamesThatExist) {
  const auto is_panel = [](std::string_view id) {
    return std::ranges::any_of(tab_infos(), [&](const TabInfo& tab) { return tab.id == id; });
  };
  const auto is_command = [](std::string_view id) {
    return std::any_of(commands().begin(), commands().end(), [&](const Command& c) { return c.id == id; });
  };
  for (const FormerName& name : former_names()) {
    EXPECT_TRUE(is_panel(name.today) || is_command(name.today)) << name.today;
    EXPECT_FALSE(is_panel(name.former) || is_command(name.former)) << name.former;
  }
}

TEST(FormerNames, OfOlderSettingsAreRead) {
  const Settings settings = settings_of_text(R"({"watches": ["vx"], "tabs": ["why", "stops", "watch", 3],
      "preferences": {"keys": {"stops/add": ["F2", ""], "tabs/watch": ["F3", ""]}}})")
                                .value();
  EXPECT_EQ(settings.plots, std::vector<std::string>{"vx"});
  EXPECT_EQ(settings.tabs, (std::vector<std::string>{"why", "breakpoints", "plots"}));
  const auto& keys = settings.preferences.keys.changed;
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_EQ(keys.at("breakpoints/add")[0], KeyChord{kKeyF2});
  EXPECT_EQ(keys.at("tabs/plots")[0], KeyChord{kKeyF3});
}

TEST(FormerNames, YieldToTodaysNames) {
  const Settings settings = settings_of_text(R"({"plots": ["vy"], "watches": ["vx"],
      "preferences": {"keys": {"breakpoints/add": ["F2", ""], "stops/add": ["F3", ""]}}})")
                                .value();
  EXPECT_EQ(settings.plots, std::vector<std::string>{"vy"});
  EXPECT_EQ(settings.preferences.keys.changed.at("breakpoints/add")[0], KeyChord{kKeyF2});
}

class SettingsFile : public FolderTest {};

TEST_F(SettingsFile, IsReadAsItWasWritten) {
  Settings settings;
  settings.width = 1000, settings.height = 700;
  settings.layout = {0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8};
  settings.canvas = CanvasMode::play;
  settings.ui_scale = 1.5;
  settings.grid = settings.screen_borders = false;
  settings.pixels = {.neighbours = true, .enlarged = true, .unfolded = true};
  settings.overlays.set(overlay::answer, true);
  settings.recent_files = {"/a.tic", "/b.tic"};
  settings.kept_folders = {"/levels"};
  settings.tabs = {"plots"};
  settings.dock_open = settings.legend_folded = settings.labels_all = true;
  settings.breakpoints = {
      {.condition = "x > 3", .body = 2, .count = 4, .each_frame = true, .enabled = false}};
  settings.plots = {"vy"};
  settings.overlay_palette = OverlayPalette::colour_blind;
  settings.preferences.font_size = 16;
  ASSERT_TRUE(save_settings(settings, path("settings.json")));
  const Settings again = load_settings(path("settings.json")).value();
  EXPECT_EQ(again.width, 1000);
  EXPECT_EQ(again.height, 700);
  EXPECT_EQ(again.layout, settings.layout);
  EXPECT_EQ(again.canvas, CanvasMode::play);
  EXPECT_EQ(again.ui_scale, 1.5);
  EXPECT_FALSE(again.grid || again.screen_borders);
  EXPECT_EQ(again.pixels, settings.pixels);
  for (const Overlay* overlay : all_overlays())
    EXPECT_EQ(again.overlays.has(*overlay), overlay == &overlay::answer) << overlay->key;
  EXPECT_EQ(again.recent_files, settings.recent_files);
  EXPECT_EQ(again.kept_folders, settings.kept_folders);
  EXPECT_EQ(again.tabs, settings.tabs);
  EXPECT_TRUE(again.dock_open && again.legend_folded && again.labels_all);
  EXPECT_EQ(again.breakpoints, settings.breakpoints);
  EXPECT_EQ(again.plots, settings.plots);
  EXPECT_EQ(again.overlay_palette, OverlayPalette::colour_blind);
  EXPECT_EQ(again.preferences, settings.preferences);
}

TEST(SettingsText, MissingAndWrongValuesGetTheirDefaults) {
  const Settings defaults = default_settings();
  EXPECT_EQ(defaults.width, 0);
  EXPECT_EQ(defaults.canvas, CanvasMode::play);
  EXPECT_TRUE(defaults.grid && defaults.screen_borders && defaults.overlays.has(overlay::floor_height));
  const Settings wrong =
      settings_of_text(R"({"width": 100, "height": "tall", "layout": {"left": 0.99, "dock": 0.4},
      "canvas": "all", "ui_scale": 9, "grid": 1, "overlays": 5, "tabs": {}, "recent_files": ["a", 7, "b"],
      "breakpoints": [{"condition": "x > 1", "count": 0}, {"body": 2}, {"condition": 3}, 4], "preferences": []})")
          .value();
  EXPECT_EQ(wrong.width, 0);
  EXPECT_EQ(wrong.height, 0);
  EXPECT_EQ(wrong.layout.left, Layout().left);
  EXPECT_EQ(wrong.layout.dock, 0.4);
  EXPECT_EQ(wrong.canvas, CanvasMode::play);
  EXPECT_EQ(wrong.ui_scale, 0);
  EXPECT_TRUE(wrong.grid);
  for (const Overlay* overlay : all_overlays())
    EXPECT_EQ(wrong.overlays.has(*overlay), defaults.overlays.has(*overlay)) << overlay->key;
  EXPECT_TRUE(wrong.tabs.empty());
  EXPECT_EQ(wrong.recent_files, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(wrong.breakpoints, std::vector<Breakpoint>{{.condition = "x > 1"}});
  EXPECT_EQ(wrong.preferences, Preferences());
  EXPECT_FALSE(settings_of_text("[]"));
}

TEST(FrameMetrics, RemembersTheLast120Frames) {
  FrameMetrics metrics;
  EXPECT_EQ(metrics.median_ms(), 0);
  EXPECT_EQ(metrics.max_ms(), 0);
  metrics.note({100, 5, 1, 1});
  for (int i = 1; i <= 119; ++i) metrics.note({static_cast<double>(i % 3), 6, i, 2});
  EXPECT_EQ(metrics.frames(), 120u);
  EXPECT_EQ(metrics.max_ms(), 100);
  metrics.note({2, 6, 7, 3});
  EXPECT_EQ(metrics.frames(), 120u);
  EXPECT_EQ(metrics.max_ms(), 2);
  EXPECT_EQ(metrics.median_ms(), 1);
  EXPECT_EQ(metrics.median_ms(&FrameCost::opengl_ms), 6);
  EXPECT_EQ(metrics.last().vertices, 7);
  EXPECT_EQ(metrics.last().draw_calls, 3);
}

// --- Colours as colour-blind people see them, in full strength: Machado, Oliveira and Fernandes (2009).
using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;
constexpr Matrix kNormal = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtan = {
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan = {
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan = {
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

Triple seen_lab(std::uint32_t rgb, const Matrix& eyes) {
  Triple linear{}, seen{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = (rgb >> (16 - 8 * i) & 255) / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  for (std::size_t i = 0; i < 3; ++i)
    seen[i] = std::clamp(eyes[i][0] * linear[0] + eyes[i][1] * linear[1] + eyes[i][2] * linear[2], 0.0, 1.0);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.95047);
  const double y = f(0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2]);
  const double z = f((0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// The smallest difference between two overlays' colours in CIELAB, where 2.3 is just noticeable.
double least_difference(OverlayPalette palette, const Matrix& eyes) {
  double least = 1e9;
  for (const Overlay* a : all_overlays()) {
    for (const Overlay* b : all_overlays()) {
      if (a == b) continue;
      const Triple u = seen_lab(overlay_color(*a, palette), eyes),
                   v = seen_lab(overlay_color(*b, palette), eyes);
      least = std::min(least, std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2]));
    }
  }
  return least;
}

TEST(OverlayPalette, StaysApartForColourBlindEyes) {
  for (const Matrix& eyes : {kNormal, kProtan, kDeutan})
    EXPECT_GT(least_difference(OverlayPalette::colour_blind, eyes), 15);
  EXPECT_GT(least_difference(OverlayPalette::colour_blind, kTritan), 7);
  EXPECT_LT(least_difference(OverlayPalette::standard, kDeutan), 7) << "else one palette would be enough";
}

}  // namespace talus::preferences_test
