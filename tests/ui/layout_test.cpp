// No widget is cut off, none overlap, and every key works.
#include <imgui_internal.h>

#include <algorithm>
#include <set>

#include <talus/formats/format.h>
#include "edit/map_rectangle.h"
#include "harness.h"
#include "panels/commands/commands.h"
#include "panels/ui/theme.h"
#include "platform/picture.h"
#include "platform/sdl_keys.h"

namespace talus::layout_test {

struct WindowSize {
  int width, height;
};

class UiLayout : public UiTest, public ::testing::WithParamInterface<WindowSize> {
 protected:
  void check_all(const std::string& what) {
    std::vector<Widget> all = app().ui().widgets.all();
    // As the map on its canvas.
    std::erase_if(all, [](const Widget& w) { return w.name == "sheet/tiles"; });
    ASSERT_GT(all.size(), 50u) << what;
    for (const Widget& w : all) check_inside(w, what);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j) check_apart(all[i], all[j], what);
  }

  static Rgb color_at(const Picture& picture, ImVec2 at) {
    const std::size_t pixel = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(at.x);
    return {picture.rgba[4 * pixel], picture.rgba[4 * pixel + 1], picture.rgba[4 * pixel + 2]};
  }

 private:
  void check_inside(const Widget& w, const std::string& what) {
    const auto size = GetParam();
    EXPECT_GE(w.min.x, 0) << what << ": " << w.name;
    EXPECT_LE(w.max.x, static_cast<float>(size.width)) << what << ": " << w.name;
    EXPECT_GE(w.min.x, w.clip_min.x - 1) << what << ": " << w.name << " is cut off at the left";
    EXPECT_LE(w.max.x, w.clip_max.x + 1) << what << ": " << w.name << " is cut off at the right";
    if (w.scrolls) return;
    EXPECT_GE(w.min.y, w.clip_min.y - 1) << what << ": " << w.name << " is cut off at the top";
    EXPECT_LE(w.max.y, w.clip_max.y + 1) << what << ": " << w.name << " is cut off at the bottom";
    EXPECT_LE(w.max.y, static_cast<float>(size.height)) << what << ": " << w.name;
  }
  // The legend may be folded, and captions lie where they hide least.
  static bool lies_in_corner_of(const Widget& widget, const Widget& canvas) {
    for (const std::string side : {"map/", "play/"}) {
      if (canvas.name == side + "canvas" &&
          (widget.name == side + "legend" || widget.name == side + "captions"))
        return true;
    }
    return false;
  }
  static void check_apart(const Widget& a, const Widget& b, const std::string& what) {
    if (lies_in_corner_of(b, a)) return;
    const auto top = [](const Widget& w) { return std::max(w.min.y, w.clip_min.y); };
    const auto bottom = [](const Widget& w) { return std::min(w.max.y, w.clip_max.y); };
    const bool meet = a.min.x < b.max.x - 0.5f && b.min.x < a.max.x - 0.5f && top(a) < bottom(b) - 0.5f &&
                      top(b) < bottom(a) - 0.5f;
    EXPECT_FALSE(meet) << what << ": " << a.name << " and " << b.name << " overlap";
    EXPECT_NE(a.name, b.name) << what;
  }
};

TEST_P(UiLayout, EveryWidgetIsWholeAndApartInEveryLayout) {
  start(save_test_level("level.talus.json"), GetParam().width, GetParam().height);
  session().apply(action::SelectBody{1});
  for (CanvasMode mode : {CanvasMode::map, CanvasMode::play, CanvasMode::both}) {
    app().ui().view.canvas.mode = mode;
    frames(3);
    check_all("canvas " + std::to_string(static_cast<int>(mode)));
  }
  click("tabs/tuning");
  click("tabs/history");
  click("tabs/color");
  frames(3);
  check_all("other tabs");
  app().ui().view.sprites.pixels = {true, true, false};
  frames(3);
  check_all("enlarged pixels");
}

TEST_P(UiLayout, PictureShowsTheLevel) {
  start(save_test_level("level.talus.json"), GetParam().width, GetParam().height);
  const auto picture = draw_picture();
  ASSERT_TRUE(picture) << picture.error();
  EXPECT_EQ(picture->width, GetParam().width);
  EXPECT_EQ(picture->height, GetParam().height);
  const Rgb solid = level().palette[13], ball = level().palette[3];
  EXPECT_EQ(color_at(*picture, on_canvas("play", {100, 132})), solid);
  EXPECT_EQ(color_at(*picture, on_canvas("play", {44, 82})), ball);
  EXPECT_EQ(color_at(*picture, on_sheet(1)), solid);
}

TEST_P(UiLayout, PictureShowsTilesInTrueColour) {
  Level drawn = test_level();
  drawn.set_tile_layout({2, 8});
  const Rgb green{40, 120, 60};  // no colour of the palette
  SheetPicture picture{16, 32, {}};
  for (int i = 0; i < 16 * 32; ++i) picture.rgba.insert(picture.rgba.end(), {green.r, green.g, green.b, 255});
  drawn.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  ASSERT_TRUE(save_level(drawn, *find_format("native"), path("level.talus.json")));
  start(path("level.talus.json"), GetParam().width, GetParam().height);
  const auto shown = draw_picture();
  ASSERT_TRUE(shown) << shown.error();
  EXPECT_EQ(color_at(*shown, on_canvas("map", {100, 132})), green) << "tile 1";
  EXPECT_EQ(color_at(*shown, on_canvas("map", {100, 100})), green) << "tile 0, which fills most of the map";
  EXPECT_EQ(color_at(*shown, on_sheet(1)), green);
}

TEST_P(UiLayout, CurvesAndPlayersAreDrawnWithoutOverlays) {
  Level drawn = test_level();
  drawn.tuning.solver = SolverKind::exact;
  drawn.curves.push_back({"", {Segment{{60, 44}, {200, 44}}, Curve::Faces::up}, ""});
  drawn.spawns.resize(1);
  drawn.spawns[0].kind = BodyKind::player;
  drawn.spawns[0].position = {80, 80};
  const std::string file = path("drawn.talus.json");
  ASSERT_TRUE(save_level(drawn, *format_for_file(file), file));
  start(file, GetParam().width, GetParam().height);
  for (const Overlay* overlay : all_overlays()) session().apply(action::SetOverlay{overlay, false});
  session().apply(action::SelectSpawn{0});
  frames(3);
  check_all("a chosen player");
  const auto picture = draw_picture();
  ASSERT_TRUE(picture) << picture.error();
  const auto rgb = [](std::uint32_t c) {
    return Rgb{static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
               static_cast<std::uint8_t>(c)};
  };
  for (const char* canvas : {"map", "play"}) {
    EXPECT_EQ(color_at(*picture, on_canvas(canvas, {101, 44})), rgb(theme::kText)) << canvas;
    EXPECT_EQ(color_at(*picture, on_canvas(canvas, {84, 85})), rgb(theme::kAccent)) << canvas;
  }
}

TEST_P(UiLayout, ArtIsAtAWholeZoom) {
  start(save_test_level("level.talus.json"), GetParam().width, GetParam().height);
  for (std::string_view name : {"sheet/tiles", "pixels/canvas"}) {
    const Widget* widget = find(name);
    ASSERT_NE(widget, nullptr);
    const float unit = name == "sheet/tiles" ? 128 : 8;
    const float zoom = (widget->max.x - widget->min.x) / unit;
    EXPECT_EQ(zoom, std::floor(zoom)) << name;
    EXPECT_EQ(widget->min.x, std::floor(widget->min.x)) << name;
    EXPECT_GE(zoom, 2) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, UiLayout,
                         ::testing::Values(WindowSize{1152, 700}, WindowSize{1280, 720},
                                           WindowSize{2560, 1440}),
                         [](const auto& size) { return std::to_string(size.param.width); });

using UiZoomButtons = UiTest;

TEST_F(UiZoomButtons, AreBesideEachOtherInEveryWidth) {
  const std::string file = save_test_level("level.talus.json");
  for (int width = 900; width <= 1280; width += 38) {
    start(file, width, 720);
    for (const std::string side : {"canvas", "sheet"}) {
      const Widget *out = find(side + "/zoom_out"), *in = find(side + "/zoom_in");
      if (out == nullptr && in == nullptr && side == "canvas")
        continue;  // both are in the menu of the toolbar
      ASSERT_TRUE(out != nullptr && in != nullptr) << side;
      EXPECT_EQ(out->min.y, in->min.y) << side << " in " << width;
      EXPECT_LT(in->min.x - out->max.x, 10) << side << " in " << width;
    }
  }
}

using UiKeys = UiTest;

TEST_F(UiKeys, EachHasOneMeaningInEachPlace) {
  const auto all = commands();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool meet = all[i].scope == Scope::everywhere || all[j].scope == Scope::everywhere ||
                        all[i].scope == all[j].scope;
      if (!meet) continue;
      for (KeyChord a : {all[i].key, all[i].other_key})
        for (KeyChord b : {all[j].key, all[j].other_key})
          EXPECT_FALSE(a && a == b) << to_string(a) << ": " << all[i].id << " and " << all[j].id;
    }
  }
}

TEST_F(UiKeys, EachReachesItsCommand) {
  start();
  for (const Command& command : commands()) {
    if (command.scope == Scope::play) continue;  // play keys are held; UiPlayer tests them
    for (KeyChord chord : {command.key, command.other_key}) {
      if (!chord) continue;
      // SDL's event for the key gives the same chord, which belongs to this command alone.
      EXPECT_EQ(chord_of(keysym_of(chord)), chord) << command.id;
      Ui& ui = app().ui();
      ui.view.window.focus = command.scope == Scope::sprites ? Focus::sprites
                             : command.scope == Scope::input ? Focus::input
                             : command.scope == Scope::shape ? Focus::shape
                                                             : Focus::map;
      Session probe(test_level());
      Ui view;
      view.problems = &probe.problems();  // every frame has them
      view.view.window.focus = ui.view.window.focus;
      if (command.scope == Scope::cursor) view.view.canvas.cursor.go_to({"map"});
      view.view.canvas.hover.cell = Cell{5, 10};
      probe.apply(action::EditLevel{erase_cells(probe.level(), {5, 10, 1, 1})});
      probe.apply(action::EditLevel{erase_cells(probe.level(), {0, 16, 1, 1})});
      probe.apply(action::Undo{});
      probe.apply(action::SelectTiles{{SheetId::tiles, {2, 2, 1, 1}}});
      Actions actions;
      EXPECT_TRUE(run_key(chord, false, probe, actions, view)) << command.id;
    }
  }
}

TEST_F(UiKeys, HelpListsThemAndClosesWithEscape) {
  start();
  key(kKeyF1);
  frames(2);
  EXPECT_NE(find("help/window"), nullptr);
  key(KeyChord{27});
  frames(2);
  EXPECT_EQ(find("help/window"), nullptr);
}

TEST_F(UiKeys, CommandPaletteRunsWhatIsTyped) {
  start();
  key(ctrl('p'));
  frames(2);
  type("step one");
  key(KeyChord{'\r'});
  frames(2);
  EXPECT_EQ(session().state().frame, 1);
  EXPECT_EQ(find("command_palette/text"), nullptr);
}

TEST_F(UiKeys, TypedTextTriggersNoShortcut) {
  start();
  click("tabs/color");
  frames(2);
  click("palette/hex");
  key('b');
  EXPECT_TRUE(session().choices().screen_borders);
}

TEST_F(UiKeys, EscapeClosesAMenuWithItsSubmenu) {
  start();
  click("menu/View");
  frames(2);
  click("menu/scale");
  frames(2);
  ASSERT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 2);
  key(KeyChord{27});
  frames(30);
  EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 0);
  EXPECT_EQ(find("menu/scale"), nullptr);
}

TEST_F(UiKeys, LayoutIsReset) {
  begin_with_the_first_layout();
  start();
  const float before = centre("layout/left").x;
  drag(centre("layout/left"), {before + 60, 300});
  EXPECT_NEAR(centre("layout/left").x, before + 60, 2);
  key(ctrl('0'));
  frames(2);
  EXPECT_EQ(centre("layout/left").x, before);
}

// Whether each tab is either whole in its bar or out of it, and the chosen one is whole.
bool has_whole_tabs(const ImGuiTabBar& bar) {
  const float left = bar.ScrollingAnim - 0.5f,
              right = left + 1 + bar.ScrollingRectMaxX - bar.ScrollingRectMinX;
  return std::ranges::all_of(bar.Tabs, [&](const ImGuiTabItem& tab) {
    const float begin = tab.Offset, end = begin + tab.Width;
    const bool is_whole = begin >= left && end <= right;
    const bool is_out = end - 1 <= left || begin + 1 >= right;
    return is_whole || (is_out && tab.ID != bar.SelectedTabId);
  });
}

TEST_F(UiKeys, TabsThatScrollAreWhole) {
  begin_with_the_first_layout();  // in the harness's own one all have room
  start();
  for (const char* chosen : {"brushes", "tile", "shape", "inspector"}) {
    app().ui().view.requests.ask(request::ShowTab{chosen});
    frames(30);
    int scrolled = 0;
    auto& bars = ImGui::GetCurrentContext()->TabBars;
    for (int i = 0; i < bars.GetMapSize(); ++i) {
      const ImGuiTabBar* const bar = bars.TryGetMapData(i);
      if (bar == nullptr || !(bar->Flags & ImGuiTabBarFlags_FittingPolicyScroll)) continue;
      ++scrolled;
      EXPECT_TRUE(has_whole_tabs(*bar)) << chosen;
    }
    EXPECT_GT(scrolled, 0);
  }
}

TEST_F(UiKeys, SmallCharactersHaveNames) {
  EXPECT_EQ(to_string(KeyChord{','}), "Comma");
  EXPECT_EQ(to_string(ctrl('.')), "Ctrl+Period");
  EXPECT_EQ(to_string(KeyChord{'`'}), "Backquote");
}

TEST_F(UiKeys, TintListShowsEveryFlag) {
  start();
  click("canvas/flag_tint");
  frames(2);
  for (int flag = 0; flag < kCartFlags; ++flag) {
    const Widget* row = find("canvas/flag_tint" + std::to_string(flag));
    ASSERT_NE(row, nullptr) << flag;
    EXPECT_LE(row->max.y, row->clip_max.y) << flag;
  }
}

TEST_F(UiKeys, TooltipOfABarStaysAboveTheBars) {
  start();
  for (std::string_view name : {"transport/step", "overlay/group_body"}) {
    move(centre(name));
    frames(60);
    const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
    ASSERT_TRUE(tooltip != nullptr && tooltip->Active) << name;
    EXPECT_LE(tooltip->Rect().Max.y, centre("transport/step").y - 12) << name;
  }
}

TEST_F(UiKeys, TooltipOfAMenuStaysBesideIt) {
  start();
  click("menu/File");
  frames(2);
  const Widget entry = *find("menu/export_as");
  move({(entry.min.x + entry.max.x) / 2, entry.min.y - (entry.max.y - entry.min.y)});  // the entry above it
  frames(60);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  ASSERT_TRUE(tooltip != nullptr && tooltip->Active);
  EXPECT_GE(tooltip->Rect().Min.x, entry.max.x);
}

TEST_F(UiKeys, NoTooltipInADialog) {
  start();
  key(ctrl('o'));
  frames(3);
  move(centre("files/confirm"));
  frames(60);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  EXPECT_TRUE(tooltip == nullptr || !tooltip->Active);
}

TEST_F(UiKeys, TooltipShowsTheKey) {
  start();
  move(centre("transport/step"));
  EXPECT_TRUE(app().ui().wants_frames());
  frames(40);
  EXPECT_FALSE(app().ui().wants_frames());
}

}  // namespace talus::layout_test
