// Computes the layout of the window.
#include "workspace.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "panels/commands/commands.h"
#include "panels/panel_ids.h"
#include "panels/tiles/flags_panel.h"
#include "panels/ui/dialog.h"
#include "panels/ui/splitter.h"

namespace talus {
namespace {

// Smallest and fixed sizes, px at scale 1.
constexpr float kLeftLeast = 236, kRightLeast = 260, kMiddleLeast = 320;
constexpr float kMaxOfNarrowWindow = 0.3f;  // of its width, for a column
constexpr float kWayBack = 56;              // height at the top, for the button to the panels
constexpr float kLowWindow = 500;           // without a status bar
constexpr float kTimeline = 28, kTransport = 30, kStatus = 20;
constexpr float kSheetTile = 24;  // side of a tile of the sheet, as it opens
constexpr float kSheetLeast = 164, kFlags = 130, kPalette = 40, kPixelsLeast = 176;
constexpr float kPictureColors = 64;    // height of the palette of a sheet in true colour
constexpr float kMargin = 6;            // px at scale 1, above and below the content of a region
constexpr float kMaxTabsOfRoom = 1.2f;  // of the width of a region; so wide tabs can be made to fit
constexpr float kRightTopLeast = 180, kRightBottomLeast = 80;
constexpr float kDockLeast = 120, kDockWanted = 164, kAboveDockLeast = 300;

// A part of `whole`, with `least` for itself and `rest` for the others, if there is room for both.
float part(double fraction, float whole, float least, float rest) {
  const float wanted = std::floor(static_cast<float>(fraction) * whole);
  return std::clamp(wanted, std::min(least, whole / 2), std::max(whole - rest, whole / 2));
}

// Where a panel is now; `floating`, which the workspace does not lay out, for a closed one.
Region region_of(const PanelPlace& place, const WindowView& window) {
  const auto moved = has_tabs(place.region) ? moved_place(window, place.panel->id()) : std::nullopt;
  if (!moved) return place.region;
  return *moved == TabPlace::closed ? Region::floating : region_of_place(*moved);
}

bool is_sprite_region(Region region) {
  return region == Region::sheet || region == Region::pixels || region == Region::palette ||
         region == Region::flags;
}

// As in other programs; Dear ImGui leaves it to us. A submenu would open again under the mouse, so all menus
// close.
void close_popup_on_escape() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty() || ImGui::GetTopMostPopupModal() != nullptr || !key_pressed(ImGuiKey_Escape)) return;
  ImGui::ClosePopupToLevel(0, true);
}

// The side of the window that a region belongs to, if it takes keys. In the dock only the input roll takes
// keys, for itself.
std::optional<Focus> side_of(Region region) {
  if (is_sprite_region(region)) return Focus::sprites;
  if (region == Region::canvas) return Focus::map;
  return region == Region::dock ? std::optional(Focus::input) : std::nullopt;
}

// A click gives a side the keys, and so does a move of the mouse into it.
bool is_pointed_at(Region region, View& view) {
  const auto side = side_of(region);
  if (!side || region == Region::dock) return false;
  const bool clicked = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
  if (clicked &&
      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
    view.window.focus = *side;
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
}

// The side that has the keys has a line at its top.
void show_focus(Region region, Ui& ui) {
  const auto side = side_of(region);
  const bool at_top = !is_sprite_region(region) || region == Region::sheet ||
                      (region == Region::pixels && ui.view.sprites.pixels.enlarged);
  if (!side || ui.view.window.focus != *side || !at_top) return;
  const ImVec2 at = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + ImGui::GetWindowWidth(), at.y + ui.px(3)},
                                            theme::tone(theme::kFocus));
}

// The widths of the columns beside the canvas, px of the screen; 0: closed.
struct Columns {
  float left = 0, right = 0;
};
// In a narrow window the canvas and one column have room.
Columns columns_of(const Ui& ui, float window, bool has_right) {
  const WindowView& view = ui.view.window;
  const float most = kMaxOfNarrowWindow * window;
  const float left_least = std::min(ui.px(kLeftLeast), most),
              right_least = std::min(ui.px(kRightLeast), most);
  const float canvas = std::max(ui.px(kMiddleLeast), window / 2);
  const bool has_room_for_one = window >= right_least + ui.px(kMiddleLeast);
  const bool has_room_for_both = window >= left_least + right_least + canvas;
  const bool is_right_first = view.first == TabPlace::right_top || view.first == TabPlace::right_bottom;
  const bool left_hides_right = view.left_open && !is_right_first && !has_room_for_both;
  Columns columns;
  if (view.right_open && has_right && has_room_for_one && !left_hides_right)
    columns.right = part(view.layout.right, window, right_least, left_least + canvas);
  if (view.left_open && (has_room_for_both || (columns.right == 0 && has_room_for_one)))
    columns.left = part(view.layout.left, window, left_least, columns.right + canvas);
  return columns;
}

// In a low window the canvas and a column have room, or the canvas and the dock. Closes what has none.
bool make_room_for_dock(const WindowView& view, bool is_low, Columns& columns) {
  if (!is_low) return true;
  const bool has_column = columns.left > 0 || columns.right > 0;
  if (has_column && view.first != TabPlace::dock) return false;
  columns = {};
  return true;
}

// A hidden side cannot keep the keys.
void leave_hidden_sprites(WindowView& view) {
  if (view.focus == Focus::sprites && (!view.left_open || view.alone)) view.focus = Focus::map;
}

void leave_input_roll(View& view) {
  if (view.window.focus == Focus::input) view.window.focus = Focus::map;
}

void leave_hidden_shape(View& view) {
  constexpr int kFramesToAppear = 5;
  const bool is_shown = ImGui::GetFrameCount() <= view.shape.last_frame + kFramesToAppear;
  if (view.window.focus == Focus::shape && !is_shown) view.window.focus = Focus::map;
}

// Tabs get a little narrower where that gives all of them room; else those that have none are in a list.
ImGuiTabBarFlags flags_of_tabs(const std::vector<Panel*>& here) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = 0;
  for (const Panel* panel : here)
    width += size_of_text(panel->title()).x + 2 * style.FramePadding.x + style.ItemInnerSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  if (width <= room) return ImGuiTabBarFlags_None;
  if (width <= kMaxTabsOfRoom * room) return ImGuiTabBarFlags_FittingPolicyResizeDown;
  return ImGuiTabBarFlags_FittingPolicyScroll | ImGuiTabBarFlags_TabListPopupButton |
         ImGuiTabBarFlags_NoTabListScrollingButtons;
}

// Of tabs that scroll, shows the chosen one with those that have room beside it, all of them whole: Dear
// ImGui would cut the first and the last one. Call it before the first tab.
void show_whole_tabs(ImGuiTabBar& bar) {
  const ImGuiID id = bar.NextSelectedTabId != 0 ? bar.NextSelectedTabId : bar.SelectedTabId;
  const ImGuiTabItem* const chosen = ImGui::TabBarFindTabByID(&bar, id);
  if (!(bar.Flags & ImGuiTabBarFlags_FittingPolicyScroll) || chosen == nullptr) return;
  const float list = ImGui::GetFontSize() + ImGui::GetStyle().FramePadding.y;  // width of its button
  const float room = bar.BarRect.GetWidth() - list;
  const auto end_of = [](const ImGuiTabItem& tab) { return tab.Offset + tab.Width; };
  const ImGuiTabItem* first = bar.Tabs.begin();
  while (first < chosen && end_of(*chosen) - first->Offset > room) ++first;
  const ImGuiTabItem* last = chosen;
  while (last + 1 < bar.Tabs.end() && end_of(last[1]) - first->Offset <= room) ++last;
  bar.ScrollingAnim = bar.ScrollingTarget = first->Offset;
  bar.BarRect.Max.x = bar.BarRect.Min.x + list + std::min(room, end_of(*last) - first->Offset);
}

// Of the panels that share a region, `id` is shown now.
void remember_tab(std::vector<std::string>& chosen, const std::vector<Panel*>& here, const std::string& id) {
  if (std::find(chosen.begin(), chosen.end(), id) != chosen.end()) return;
  for (const Panel* panel : here) std::erase(chosen, panel->id());
  chosen.push_back(id);
}

}  // namespace

void Workspace::draw(const Session& session, Actions& actions, Ui& ui) {
  close_popup_on_escape();
  Frame frame{session, actions, ui};
  pointed_at_.reset();
  open_wanted_columns(ui.view);
  leave_hidden_sprites(ui.view.window);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const bool alone = ui.view.window.alone;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(window);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin(kWorkspaceWindow, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                   (alone ? ImGuiWindowFlags_None : ImGuiWindowFlags_MenuBar));
  ImGui::PopStyleVar();
  if (alone)
    draw_alone(frame, window);
  else
    draw_regions(frame, window);
  ImGui::End();
  for (PanelPlace& place : panels_)
    if (place.region == Region::floating) place.panel->draw(session, actions, ui);
  follow_mouse(ui.view);
  leave_hidden_shape(ui.view);
}

// Who asks for a panel wants to see it.
void Workspace::open_wanted_columns(View& view) const {
  for (const PanelPlace& place : panels_) {
    const std::string_view id = place.panel->id();
    if (!view.requests.has<request::ShowTab>(id) && !view.requests.has<request::FocusPanel>(id)) continue;
    view.window.alone = false;
    reopen_tab(view.window, id);
    const Region region = region_of(place, view.window);
    if (is_sprite_region(region)) view.window.left_open = true;
    const auto tabs = place_of_region(region);
    if (tabs && !is_open_at(view.window, *tabs)) {
      open_place(view.window, *tabs);
      view.requests.ask(request::KeepZoom{});
    }
    if (tabs || is_sprite_region(region)) view.window.first = tabs.value_or(TabPlace::left);
  }
}

bool Workspace::has_panels(Region region, const WindowView& window) const {
  return std::ranges::any_of(panels_,
                             [&](const PanelPlace& place) { return region_of(place, window) == region; });
}

// Where a tab may be let go: the regions with tabs, and the edges of the canvas.
void Workspace::note_tab_areas(ImVec2 canvas_min, ImVec2 canvas_max) {
  const float side = (canvas_max.x - canvas_min.x) / 5, below = (canvas_max.y - canvas_min.y) / 4;
  tab_hand_.add_area(TabPlace::dock, {canvas_min.x + side, canvas_max.y - below},
                     {canvas_max.x - side, canvas_max.y});
  tab_hand_.add_area(TabPlace::left, canvas_min, {canvas_min.x + side, canvas_max.y});
  tab_hand_.add_area(TabPlace::right_top, {canvas_max.x - side, canvas_min.y}, canvas_max);
}

void Workspace::draw_regions(Frame& frame, ImVec2 window) {
  Ui& ui = frame.ui;
  for (PanelPlace& place : panels_)
    if (place.region == Region::menu) place.panel->draw(frame.session, frame.actions, ui);
  const float top = ImGui::GetCursorScreenPos().y, bar = ui.px(kSplitterWidth);
  const float status = window.y < ui.px(kLowWindow) ? 0 : ui.px(kStatus);
  const float bottom = window.y - status - ui.px(kTransport) - ui.px(kTimeline);
  ui.bars_top = bottom;
  tab_hand_.begin_frame();
  WindowView& view = ui.view.window;
  const bool has_right = has_panels(Region::right_top, view) || has_panels(Region::right_bottom, view);
  Columns columns = columns_of(ui, window.x, has_right);
  const bool is_low = bottom - top < ui.px(kDockLeast + kAboveDockLeast);
  const bool has_dock =
      view.dock_open && has_panels(Region::dock, view) && make_room_for_dock(view, is_low, columns);
  const float left = columns.left, right = columns.right;
  view.left_shown = left > 0;
  view.right_shown = right > 0;
  Layout& layout = view.layout;
  if (left > 0) draw_left(frame, {0, top}, {left, bottom - top});
  if (!has_dock) leave_input_roll(ui.view);
  const float dock = has_dock ? draw_dock(frame, {left, top}, {window.x - left, bottom - top}) : 0;
  const float height = bottom - top - dock;
  float x = left, end = window.x - right;
  if (left > 0) {
    ImGui::SetCursorScreenPos({left, top});
    const float moved = splitter("layout/left", {bar, height}, SplitterAxis::horizontal, ui);
    if (moved != 0) layout.left = (left + moved) / window.x;
    x += bar;
  }
  if (right > 0) end -= bar;
  const float above = draw_enlarged_pixels(frame, {x, top}, {end - x, height});
  draw_region(frame, Region::canvas, {x, top + above}, {end - x, height - above});
  note_tab_areas({x, top + above}, {end, top + height});
  const bool is_at_left = right == 0 && left > 0;
  ui.side_min = {is_at_left ? 0 : window.x - (right > 0 ? right : ui.px(kRightLeast)), top};
  ui.side_max = is_at_left ? ImVec2(left, bottom) : ImVec2(window.x, top + height);
  if (right > 0) {
    ImGui::SetCursorScreenPos({end, top});
    const float moved = splitter("layout/right", {bar, height}, SplitterAxis::horizontal, ui);
    if (moved != 0) layout.right = (right - moved) / window.x;
    draw_right(frame, {window.x - right, top}, {right, height});
  }
  draw_region(frame, Region::timeline, {0, bottom}, {window.x, ui.px(kTimeline)});
  draw_region(frame, Region::transport, {0, bottom + ui.px(kTimeline)}, {window.x, ui.px(kTransport)});
  if (status > 0) draw_region(frame, Region::status, {0, window.y - status}, {window.x, status});
  tab_hand_.end_frame(ui);
  alone_since_ = -1;
}

// At first for some seconds, and then while the mouse is at the top, a button says how the panels come back.
void Workspace::draw_alone(Frame& frame, ImVec2 window) {
  constexpr double kShown = 4;  // s
  Ui& ui = frame.ui;
  ui.bars_top = window.y;
  ui.side_min = {window.x - ui.px(kRightLeast), 0};
  ui.side_max = window;
  if (ui.view.window.focus != Focus::shape) ui.view.window.focus = Focus::map;
  draw_region(frame, Region::canvas, {0, 0}, window);
  if (alone_since_ < 0) alone_since_ = ui.time;
  const bool is_first = ui.time <= alone_since_ + kShown;
  const float mouse = ImGui::GetIO().MousePos.y;
  if (!is_first && !(mouse >= 0 && mouse < ui.px(kWayBack))) return;
  ui.want_frames();
  ImGui::SetNextWindowPos({window.x / 2, ui.px(8)}, ImGuiCond_Always, {0.5f, 0});
  ImGui::Begin("way back", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  const std::string label = "Show the panels: " + keys_of("view/alone"_command, ui) + " or Esc";
  command_text_button("view/alone"_command, frame.session, frame.actions, ui,
                      {.label = label, .widget = "alone/back"});
  ImGui::End();
}

// A press is meant for the part under the mouse. Only a move into a side counts: F2 and F3 stay in effect
// while the mouse rests, and a dialog that closes above it changes nothing.
void Workspace::follow_mouse(View& view) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x == 0 && moved.y == 0) return;
  if (pointed_at_ && pointed_at_ != pointed_before_) {
    view.window.focus = *pointed_at_;
    leave_windows();
  }
  pointed_before_ = pointed_at_;
}

// The sheet and the flags alone: the pixels are folded away.
void Workspace::draw_left_folded(Frame& frame, ImVec2 at, ImVec2 size) {
  Ui& ui = frame.ui;
  const float spare = std::max(0.0f, std::floor((size.y - ui.px(kFlags + kSheetLeast)) / 2));
  const bool has_flags = has_panels(Region::flags, ui.view.window);
  const float flags =
      has_flags ? ui.px(kFlags) + std::min(spare, height_of_more_flags(frame.session.level(), ui)) : 0;
  draw_region(frame, Region::sheet, at, {size.x, size.y - flags});
  if (has_flags) draw_region(frame, Region::flags, {at.x, at.y + size.y - flags}, {size.x, flags});
}

void Workspace::draw_left(Frame& frame, ImVec2 at, ImVec2 size) {
  Ui& ui = frame.ui;
  const SheetId shown = frame.session.choices().area.sheet;
  const bool in_rgba = is_in_rgba(frame.session.level(), shown);
  const PixelView& view = ui.view.sprites.pixels;
  const float bar = ui.px(kSplitterWidth);
  const bool is_low = size.y < ui.px(kSheetLeast + kPixelsLeast + kFlags) + bar;  // pixels would be cut off
  if ((is_low || (in_rgba && !view.unfolded)) && !view.enlarged) return draw_left_folded(frame, at, size);
  const bool has_flags = has_panels(Region::flags, ui.view.window);
  float flags = has_flags ? ui.px(kFlags) : 0;
  const float palette = ui.px(in_rgba ? kPictureColors : kPalette);
  const float pixels_least = ui.px(kPixelsLeast - kPalette) + palette;
  // At most as high as the sheet with tiles as large as its width allows.
  const SheetLayout& layout = ui.layout(shown);
  const float tile =
      std::max(ui.px(kSheetTile), std::floor((size.x - ui.px(16)) / static_cast<float>(layout.columns)));
  const float header = 2 * ui.px(kMargin) + ui.px(theme::kButton) + ImGui::GetStyle().ItemSpacing.y;
  const float least = ui.px(kSheetLeast), rest = flags + pixels_least + bar;
  const float wanted = std::floor(static_cast<float>(ui.view.window.layout.sheet) * size.y);
  // A sheet of a cart is seen at twice its size in a low window, too.
  const float most = std::max({size.y - rest, least, in_rgba ? 0 : size.y / 2});
  const float highest = std::max(least, tile * static_cast<float>(layout.rows()) + header);
  const float sheet = std::min(std::clamp(wanted, least, most), highest);
  // More flags than a cart's take up to half of the room that the pixels do not need.
  float pixels = size.y - sheet - flags - bar;
  const float spare = std::max(0.0f, std::floor((pixels - pixels_least) / 2));
  const float more = std::min(spare, height_of_more_flags(frame.session.level(), ui));
  if (has_flags) {
    flags += more;
    pixels -= more;
  }
  draw_region(frame, Region::sheet, at, {size.x, sheet});
  ImGui::SetCursorScreenPos({at.x, at.y + sheet});
  const float moved = splitter("layout/sheet", {size.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.sheet = (sheet + moved) / size.y;
  const float y = at.y + sheet + bar;
  if (view.enlarged) {  // elsewhere: the flags get the room that is left
    const float colors = std::min(pixels, 3 * ui.px(kPalette));
    draw_region(frame, Region::palette, {at.x, y}, {size.x, colors});
    if (has_flags) draw_region(frame, Region::flags, {at.x, y + colors}, {size.x, pixels - colors + flags});
  } else {
    draw_region(frame, Region::pixels, {at.x, y}, {size.x, pixels - palette});
    draw_region(frame, Region::palette, {at.x, y + pixels - palette}, {size.x, palette});
    if (has_flags) draw_region(frame, Region::flags, {at.x, y + pixels}, {size.x, flags});
  }
}

float Workspace::draw_enlarged_pixels(Frame& frame, ImVec2 at, ImVec2 room) {
  Ui& ui = frame.ui;
  if (!ui.view.sprites.pixels.enlarged) return 0;
  const float bar = ui.px(kSplitterWidth), least = ui.px(kPixelsLeast);
  const float height = part(ui.view.window.layout.pixels, room.y, least, least + bar);
  draw_region(frame, Region::pixels, at, {room.x, height});
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  const float moved = splitter("layout/pixels", {room.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.pixels = (height + moved) / room.y;
  return height + bar;
}

void Workspace::draw_right(Frame& frame, ImVec2 at, ImVec2 size) {
  Ui& ui = frame.ui;
  // A region without panels, or that is not shown, leaves its room to the other.
  if (!ui.view.window.right_low_open && has_panels(Region::right_top, ui.view.window))
    return draw_region(frame, Region::right_top, at, size);
  for (const Region alone : {Region::right_top, Region::right_bottom})
    if (!has_panels(alone == Region::right_top ? Region::right_bottom : Region::right_top, ui.view.window))
      return draw_region(frame, alone, at, size);
  const float bar = ui.px(kSplitterWidth);
  const float least = ui.px(kRightBottomLeast) + bar;
  float upper = part(ui.view.window.layout.right_split, size.y, ui.px(kRightTopLeast), least);
  // The lower panel makes room for messages, and keeps its place as long as it can.
  const float room = size.y - std::min(ui.messages_height, size.y / 2);
  upper = std::min(upper, std::max(room - least, room / 2));
  draw_region(frame, Region::right_top, at, {size.x, upper});
  ImGui::SetCursorScreenPos({at.x, at.y + upper});
  const float moved = splitter("layout/right_split", {size.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.right_split = (upper + moved) / size.y;
  draw_region(frame, Region::right_bottom, {at.x, at.y + upper + bar}, {size.x, room - upper - bar});
}

float Workspace::draw_dock(Frame& frame, ImVec2 at, ImVec2 room) {
  Ui& ui = frame.ui;
  const float bar = ui.px(kSplitterWidth);
  // In a low window the input roll leaves its last line to the canvas.
  const bool is_low = room.y < ui.px(kDockWanted + kAboveDockLeast);
  const float height = part(ui.view.window.layout.dock, room.y, ui.px(is_low ? kDockLeast : kDockWanted),
                            ui.px(kAboveDockLeast));
  const float y = at.y + room.y - height;
  ImGui::SetCursorScreenPos({at.x, y});
  const float moved = splitter("layout/dock", {room.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.dock = (height - moved) / room.y;
  draw_region(frame, Region::dock, {at.x, y + bar}, {room.x, height - bar});
  return height;
}

void Workspace::draw_region(Frame& frame, Region region, ImVec2 at, ImVec2 size) {
  Ui& ui = frame.ui;
  const bool bar = region == Region::transport || region == Region::status || region == Region::pixels ||
                   region == Region::palette;
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(ui.px(region == Region::canvas ? 4 : 8), ui.px(region == Region::timeline ? 2
                                                                            : bar                      ? 3
                                                                                  : kMargin)));
  ImGui::BeginChild(static_cast<ImGuiID>(region) + 1, size, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (is_pointed_at(region, ui.view)) pointed_at_ = side_of(region);
  show_focus(region, ui);
  if (has_tabs(region))
    draw_tabs(frame, region);
  else
    draw_only_panel(frame, region);
  ImGui::EndChild();
  if (const auto place = place_of_region(region))
    tab_hand_.add_area(*place, at, {at.x + size.x, at.y + size.y});
}

void Workspace::draw_panel(Panel& panel, Frame& frame) {
  View& view = frame.ui.view;
  const bool takes_keys = view.requests.take<request::FocusPanel>(panel.id());
  if (takes_keys) {
    view.window.keys_in_panel = true;
    frame.ui.focus_next_item();
  }
  panel.draw(frame.session, frame.actions, frame.ui);
  if (takes_keys) frame.ui.focus_next_item(false);
}

void Workspace::draw_only_panel(Frame& frame, Region region) {
  for (PanelPlace& place : panels_)
    if (place.region == region) draw_panel(*place.panel, frame);
}

void Workspace::draw_tabs(Frame& frame, Region region) {
  std::vector<Panel*> here;
  for (PanelPlace& place : panels_)
    if (region_of(place, frame.ui.view.window) == region) here.push_back(place.panel.get());
  // Dear ImGui shows the first tab in the first frame, and the remembered one from the second frame on.
  const bool first = ImGui::IsWindowAppearing();
  if (!ImGui::BeginTabBar("tabs", flags_of_tabs(here))) return;
  show_whole_tabs(*ImGui::GetCurrentContext()->CurrentTabBar);
  std::vector<std::string>& chosen = frame.ui.view.window.tabs;
  Requests& requests = frame.ui.view.requests;
  std::vector<std::string>& wanted_tabs = frame.ui.view.window.wanted_tabs;
  const auto is_wanted = [&](const Panel* panel) {
    return requests.has<request::ShowTab>(panel->id()) ||
           std::find(wanted_tabs.begin(), wanted_tabs.end(), panel->id()) != wanted_tabs.end();
  };
  const bool asked = std::any_of(here.begin(), here.end(), is_wanted);
  for (Panel* panel : here) {
    const std::string id(panel->id());
    const bool wanted =
        asked ? is_wanted(panel) : first && std::find(chosen.begin(), chosen.end(), id) != chosen.end();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(frame.ui.px(2), frame.ui.px(4)));
    const bool open =
        begin_tab_item(panel->title(), id, wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ImGui::PopStyleVar();
    frame.ui.item("tabs/" + id);
    tab_hand_.take_tab(id, panel->title(), frame.ui);
    if (!open) continue;
    if (!first) remember_tab(chosen, here, id);
    requests.take<request::ShowTab>(id);
    std::erase(wanted_tabs, id);
    if (region == Region::dock && id != panel_id::kInputRoll && !asked) leave_input_roll(frame.ui.view);
    draw_panel(*panel, frame);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace talus
