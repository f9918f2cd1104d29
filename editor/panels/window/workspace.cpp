// Computes the layout of the window.
#include "workspace.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "panels/panel_ids.h"
#include "panels/tiles/flags_panel.h"
#include "panels/ui/dialog.h"
#include "panels/ui/splitter.h"

namespace talus {
namespace {

// Smallest and fixed sizes, px at scale 1.
constexpr float kLeftLeast = 276, kRightLeast = 280, kMiddleLeast = 320;
constexpr float kTimeline = 28, kTransport = 30, kStatus = 20;
constexpr float kSheetTile = 24;  // side of a tile of the sheet, as it opens
constexpr float kSheetLeast = 164, kFlags = 130, kPalette = 40, kPixelsLeast = 176;
constexpr float kPictureColors = 64;  // height of the palette of a sheet in true colour
constexpr float kMargin = 6;          // px at scale 1, above and below the content of a region
constexpr float kRightTopLeast = 180, kRightBottomLeast = 80;
constexpr float kDockLeast = 120, kAboveDockLeast = 300;

// A part of `whole`, with `least` for itself and `rest` for the others, if there is room for both.
float part(double fraction, float whole, float least, float rest) {
  const float wanted = std::floor(static_cast<float>(fraction) * whole);
  return std::clamp(wanted, std::min(least, whole / 2), std::max(whole - rest, whole / 2));
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

// The side that has the keys has an accent at its top.
void show_focus(Region region, Ui& ui) {
  const auto side = side_of(region);
  const bool at_top = !is_sprite_region(region) || region == Region::sheet ||
                      (region == Region::pixels && ui.view.sprites.pixels.enlarged);
  if (!side || ui.view.window.focus != *side || !at_top) return;
  const ImVec2 at = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + ImGui::GetWindowWidth(), at.y + ui.px(3)},
                                            theme::tone(theme::kAccent));
}

// A hidden side cannot keep the keys.
void leave_input_roll(View& view) {
  if (view.window.focus == Focus::input) view.window.focus = Focus::map;
}

void leave_hidden_shape(View& view) {
  constexpr int kFramesToAppear = 5;
  const bool is_shown = ImGui::GetFrameCount() <= view.shape.last_frame + kFramesToAppear;
  if (view.window.focus == Focus::shape && !is_shown) view.window.focus = Focus::map;
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
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(window);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin(kWorkspaceWindow, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_MenuBar |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  for (PanelPlace& place : panels_)
    if (place.region == Region::menu) place.panel->draw(session, actions, ui);

  const float top = ImGui::GetCursorScreenPos().y, bar = ui.px(kSplitterWidth);
  const float bottom = window.y - ui.px(kStatus) - ui.px(kTransport) - ui.px(kTimeline);
  ui.bars_top = bottom;
  Layout& layout = ui.view.window.layout;
  const float right = part(layout.right, window.x, ui.px(kRightLeast), ui.px(kLeftLeast + kMiddleLeast));
  const float left = part(layout.left, window.x, ui.px(kLeftLeast), right + ui.px(kMiddleLeast));
  draw_left(frame, {0, top}, {left, bottom - top});
  const float dock = draw_dock(frame, {left, top}, {window.x - left, bottom - top});
  const float height = bottom - top - dock;
  ImGui::SetCursorScreenPos({left, top});
  const float moved_left = splitter("layout/left", {bar, height}, SplitterAxis::horizontal, ui);
  if (moved_left != 0) layout.left = (left + moved_left) / window.x;
  const float middle = window.x - left - right - 2 * bar;
  const float above = draw_enlarged_pixels(frame, {left + bar, top}, {middle, height});
  draw_region(frame, Region::canvas, {left + bar, top + above}, {middle, height - above});
  ui.side_min = {window.x - right, top};
  ui.side_max = {window.x, top + height};
  ImGui::SetCursorScreenPos({window.x - right - bar, top});
  const float moved_right = splitter("layout/right", {bar, height}, SplitterAxis::horizontal, ui);
  if (moved_right != 0) layout.right = (right - moved_right) / window.x;
  draw_right(frame, {window.x - right, top}, {right, height});
  draw_region(frame, Region::timeline, {0, bottom}, {window.x, ui.px(kTimeline)});
  draw_region(frame, Region::transport, {0, bottom + ui.px(kTimeline)}, {window.x, ui.px(kTransport)});
  draw_region(frame, Region::status, {0, window.y - ui.px(kStatus)}, {window.x, ui.px(kStatus)});
  ImGui::End();
  for (PanelPlace& place : panels_)
    if (place.region == Region::floating) place.panel->draw(session, actions, ui);
  follow_mouse(ui.view);
  leave_hidden_shape(ui.view);
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
  const float flags = ui.px(kFlags) + std::min(spare, height_of_more_flags(frame.session.level(), ui));
  draw_region(frame, Region::sheet, at, {size.x, size.y - flags});
  draw_region(frame, Region::flags, {at.x, at.y + size.y - flags}, {size.x, flags});
}

void Workspace::draw_left(Frame& frame, ImVec2 at, ImVec2 size) {
  Ui& ui = frame.ui;
  const SheetId shown = frame.session.choices().area.sheet;
  const bool in_rgba = is_in_rgba(frame.session.level(), shown);
  const PixelView& view = ui.view.sprites.pixels;
  if (in_rgba && !view.unfolded && !view.enlarged) return draw_left_folded(frame, at, size);
  const float bar = ui.px(kSplitterWidth);
  float flags = ui.px(kFlags);
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
  flags += more;
  pixels -= more;
  draw_region(frame, Region::sheet, at, {size.x, sheet});
  ImGui::SetCursorScreenPos({at.x, at.y + sheet});
  const float moved = splitter("layout/sheet", {size.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.sheet = (sheet + moved) / size.y;
  const float y = at.y + sheet + bar;
  if (view.enlarged) {  // elsewhere: the flags get the room that is left
    const float colors = std::min(pixels, 3 * ui.px(kPalette));
    draw_region(frame, Region::palette, {at.x, y}, {size.x, colors});
    draw_region(frame, Region::flags, {at.x, y + colors}, {size.x, pixels - colors + flags});
  } else {
    draw_region(frame, Region::pixels, {at.x, y}, {size.x, pixels - palette});
    draw_region(frame, Region::palette, {at.x, y + pixels - palette}, {size.x, palette});
    draw_region(frame, Region::flags, {at.x, y + pixels}, {size.x, flags});
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
  if (!ui.view.window.dock_open) {
    leave_input_roll(ui.view);
    return 0;
  }
  const float bar = ui.px(kSplitterWidth);
  const float height = part(ui.view.window.layout.dock, room.y, ui.px(kDockLeast), ui.px(kAboveDockLeast));
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
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(region == Region::timeline ? 2
                                                                          : bar                      ? 3
                                                                                : kMargin)));
  ImGui::BeginChild(static_cast<ImGuiID>(region) + 1, size, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (is_pointed_at(region, ui.view)) pointed_at_ = side_of(region);
  show_focus(region, ui);
  draw_tabs(frame, region);
  ImGui::EndChild();
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

void Workspace::draw_tabs(Frame& frame, Region region) {
  std::vector<Panel*> here;
  for (PanelPlace& place : panels_)
    if (place.region == region) here.push_back(place.panel.get());
  if (here.size() == 1) {
    draw_panel(*here[0], frame);
    return;
  }
  // Dear ImGui shows the first tab in the first frame, and the remembered one from the second frame on.
  const bool first = ImGui::IsWindowAppearing();
  if (!ImGui::BeginTabBar("tabs")) return;
  std::vector<std::string>& chosen = frame.ui.view.window.tabs;
  Requests& requests = frame.ui.view.requests;
  const auto is_wanted = [&](const Panel* panel) { return requests.has<request::ShowTab>(panel->id()); };
  const bool asked = std::any_of(here.begin(), here.end(), is_wanted);
  for (Panel* panel : here) {
    const std::string id(panel->id());
    const bool wanted =
        asked ? is_wanted(panel) : first && std::find(chosen.begin(), chosen.end(), id) != chosen.end();
    // Between tabs: six of them fit into a window 1152 px wide.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(frame.ui.px(2), frame.ui.px(4)));
    const bool open =
        begin_tab_item(panel->title(), id, wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ImGui::PopStyleVar();
    frame.ui.item("tabs/" + id);
    if (!open) continue;
    if (!first) remember_tab(chosen, here, id);
    requests.take<request::ShowTab>(id);
    if (region == Region::dock && id != panel_id::kInputRoll && !asked) leave_input_roll(frame.ui.view);
    draw_panel(*panel, frame);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace talus
