// Fields, a preview, and the question before anything is lost.
#include "resize_panel.h"

#include <algorithm>
#include <string>
#include <utility>

#include "edit/map_resize.h"
#include "map_size.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr float kPreviewWidth = 300, kPreviewHeight = 170;  // px at scale 1

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool is_in(int number, int least, int most) { return number >= least && number <= most; }

// Why such a map of tiles of a size is not possible; empty if it is.
std::string problem_of(const MapFrame& frame, TileSize tile) {
  const std::string most = std::to_string(kMaxTerrainSide);
  const std::string problem = problem_of_map_size(frame.width, frame.height, tile);
  if (!problem.empty()) return problem;
  if (!is_in(frame.shift.x, -kMaxTerrainSide, kMaxTerrainSide) ||
      !is_in(frame.shift.y, -kMaxTerrainSide, kMaxTerrainSide))
    return "Everything is shifted by at most " + most + " cells, either way.";
  return "";
}

// Says what happens to the map in the cart that its level came from.
void draw_cart_note(const MapFrame& frame) {
  if (frame.width > kTicMapWidth || frame.height > kTicMapHeight)
    draw_map_note("Too large for a TIC-80 cart, which holds 240x136 cells.", theme::kWarning);
  else if (frame.width < kTicMapWidth || frame.height < kTicMapHeight)
    draw_map_note("In a TIC-80 cart it is the top left of 240x136 cells.", theme::kMuted);
}

std::string text_of_losses(const ResizedMap& result) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, one, many);
  };
  add(result.lost_tiles, "tile", "tiles");
  add(result.lost_spawns, "body", "bodies");
  add(result.lost_curves, "curve", "curves");
  return text;
}

}  // namespace

void ResizePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const TileMap& map = session.level().map;
  if (ui.view.level.resize_open && !was_open_) {
    typed_ = frame_ = {map.width(), map.height(), {0, 0}, false};
    anchor_ = {0, 0};
    asks_ = false;
  }
  was_open_ = ui.view.level.resize_open;
  const auto is_open = [](const Session&, const View& view) { return view.level.resize_open; };
  if (!begin_dialog("Size of the map", is_open, {0, 0}, session, ui)) return;
  ui.begin_row();
  draw_fields(map, ui);
  ImGui::SameLine(0, ui.px(16));
  draw_preview(map, ui);
  ui.end_row();
  ImGui::Spacing();
  draw_answers(session, actions, ui);
  ImGui::EndPopup();
}

void ResizePanel::draw_fields(const TileMap& map, Ui& ui) {
  ImGui::BeginDisabled(asks_);
  ImGui::BeginGroup();
  draw_sizes(map, ui);
  draw_anchors(map, ui);
  draw_shift(ui);
  ImGui::EndGroup();
  ImGui::EndDisabled();
  if (problem_of(typed_, map.tile_size()).empty()) frame_ = typed_;
}

void ResizePanel::draw_sizes(const TileMap& map, Ui& ui) {
  const Cell before{typed_.width, typed_.height};
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  draw_map_number("resize/width", "Width", typed_.width,
                  "Cells in a row; TIC-80 has 240. " + text_of_map_limits(), ui);
  ImGui::SameLine();
  draw_text("now " + std::to_string(map.width()));
  draw_map_number("resize/height", "Height", typed_.height,
                  "Rows of cells; TIC-80 has 136. " + text_of_map_limits(), ui);
  ImGui::SameLine();
  draw_text("now " + std::to_string(map.height()));
  if (before != Cell{typed_.width, typed_.height}) choose_anchor(map);
}

// Where the map grows or is cut, as a square of nine buttons.
void ResizePanel::draw_anchors(const TileMap& map, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Keep");
  ImGui::SameLine(ui.px(kMapLabel));
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), ui.px(2)));
  for (int i = 0; i < 9; ++i) {
    const Cell anchor{i % 3, i / 3};
    if (anchor.x > 0) ImGui::SameLine();
    if (ui.text_button("resize/anchor" + std::to_string(i), " ", anchor == anchor_,
                       "Which side or corner of the old map stays where it is.", {}, true, ui.px(24))) {
      anchor_ = anchor;
      choose_anchor(map);
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndGroup();
}

void ResizePanel::choose_anchor(const TileMap& map) {
  if (!is_terrain_size(typed_.width, typed_.height, map.tile_size())) return;
  typed_.shift = {(typed_.width - map.width()) * anchor_.x / 2,
                  (typed_.height - map.height()) * anchor_.y / 2};
}

void ResizePanel::draw_shift(Ui& ui) {
  draw_map_number("resize/right", "Right by", typed_.shift.x,
                  "Cells that everything goes to the right; or left, below 0.", ui);
  draw_map_number("resize/down", "Down by", typed_.shift.y,
                  "Cells that everything goes down; or up, below 0.", ui);
  ImGui::Checkbox("Wrap around the edges##wrap", &typed_.wrap);
  ui.item("resize/wrap",
          "Things that leave the map at one side come in at the other, instead of being cut off.");
}

// The old map and the new one as frames, with the tiles. Lost ones are marked.
void ResizePanel::draw_preview(const TileMap& map, const Ui& ui) const {
  const ImVec2 at = ImGui::GetCursorScreenPos(), room{ui.px(kPreviewWidth), ui.px(kPreviewHeight)};
  ImGui::Dummy(room);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, theme::color(theme::kOutside));
  const CellRect old{frame_.shift.x, frame_.shift.y, map.width(), map.height()};
  const int left = std::min(0, old.x), top = std::min(0, old.y);
  const int right = std::max(frame_.width, old.x + old.w), bottom = std::max(frame_.height, old.y + old.h);
  const float margin = ui.px(4);
  const float cell = std::min((room.x - 2 * margin) / static_cast<float>(right - left),
                              (room.y - 2 * margin) / static_cast<float>(bottom - top));
  const auto place = [&](int x, int y) {
    return ImVec2{at.x + margin + static_cast<float>(x - left) * cell,
                  at.y + margin + static_cast<float>(y - top) * cell};
  };
  list.AddRectFilled(place(0, 0), place(frame_.width, frame_.height), theme::color(theme::kDark));
  // No more marks than px can tell apart.
  const int step = std::max(1, static_cast<int>(ui.px(2) / cell));
  for (int y = 0; y < map.height(); y += step) {
    for (int x = 0; x < map.width(); x += step) {
      if (map.tile_at({x, y}) == 0) continue;
      Cell to{x + old.x, y + old.y};
      if (frame_.wrap && result_) {
        const int across = std::max(map.width(), frame_.width), down = std::max(map.height(), frame_.height);
        to = {((to.x % across) + across) % across, ((to.y % down) + down) % down};
      }
      const bool kept = to.x >= 0 && to.y >= 0 && to.x < frame_.width && to.y < frame_.height;
      list.AddRectFilled(place(to.x, to.y), place(to.x + step, to.y + step),
                         theme::tone(kept ? theme::kMuted : theme::kError));
    }
  }
  list.AddRect(place(old.x, old.y), place(old.x + old.w, old.y + old.h), theme::tone(theme::kMuted));
  list.AddRect(place(0, 0), place(frame_.width, frame_.height), theme::tone(theme::kAccent), 0, 0, ui.px(2));
}

void ResizePanel::draw_answers(const Session& session, Actions& actions, Ui& ui) {
  const TileMap& map = session.level().map;
  const std::string problem = problem_of(typed_, map.tile_size());
  const bool fits = problem.empty();
  const bool changes =
      frame_.width != map.width() || frame_.height != map.height() || frame_.shift != Cell{0, 0};
  const std::string losses = fits ? text_of_losses(result(session)) : "";
  if (!fits)
    draw_map_note(problem, theme::kError);  // the rest shows the last possible size
  else if (losses.empty())
    draw_map_note(changes ? "Nothing is lost." : "Type another size, or how far everything is shifted.",
                  theme::kMuted);
  else
    draw_map_note((asks_ ? "Lose " : "No place for ") + losses + (asks_ ? "? Undo brings them back." : "."),
                  theme::kWarning);
  if (session.level().cart && fits) draw_cart_note(frame_);
  bool resizes = false, goes_back = false;
  if (asks_) {  // a second click in the same place goes back
    goes_back = draw_cancel(ui);
    ImGui::SameLine();
    resizes = draw_apply(true, ui);
  } else {
    resizes = draw_apply(fits && changes, ui);
    ImGui::SameLine();
    goes_back = draw_cancel(ui);
  }
  if (goes_back) {
    if (!std::exchange(asks_, false)) close(ui);
  } else if (resizes && !losses.empty() && !asks_) {
    asks_ = began_to_ask_ = true;
  } else if (resizes) {
    actions.push_back(action::EditLevel{resize_map(session.level(), frame_, session.choices().selection)});
    close(ui);
  }
}

// Enter never presses a button that loses something.
bool ResizePanel::draw_apply(bool enabled, Ui& ui) const {
  return dialog_button({.widget = "resize/apply",
                        .label = asks_ ? "Lose them" : "Resize",
                        .help = "Gives the map this size; one Undo takes it back.",
                        .letter = asks_ ? 'L' : 'R',
                        .is_default = !asks_,
                        .enabled = enabled,
                        .width = ui.px(96)},
                       ui);
}

bool ResizePanel::draw_cancel(Ui& ui) {
  if (std::exchange(began_to_ask_, false)) ui.focus_next_item();
  return dialog_button({.widget = "resize/cancel",
                        .label = asks_ ? "Back" : "Cancel",
                        .help = "Changes nothing.",
                        .letter = asks_ ? 'B' : 'C',
                        .is_default = asks_,
                        .is_cancel = true,
                        .width = ui.px(96)},
                       ui);
}

const ResizedMap& ResizePanel::result(const Session& session) {
  if (!result_ || result_frame_ != frame_ || result_revision_ != session.revision()) {
    result_ = resized(session.level(), frame_);
    result_frame_ = frame_;
    result_revision_ = session.revision();
  }
  return *result_;
}

void ResizePanel::close(Ui& ui) {
  ui.view.level.resize_open = false;
  result_.reset();
}

}  // namespace talus
