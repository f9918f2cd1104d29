// The canvas: camera, mouse and the order of the layers.
#include "level_canvas.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "body_drawing.h"
#include "body_note.h"
#include "canvas_layers.h"
#include "case_note.h"
#include "fix_preview.h"
#include "mouse_mark.h"
#include "object_drawing.h"
#include "opening_area.h"
#include "other_side.h"
#include "overlay/number_label.h"
#include "overlay_painter.h"
#include "panels/commands/commands.h"
#include "panels/debugger/compare_choice.h"
#include "panels/debugger/input_roll.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/wrapped_text.h"
#include "plates.h"
#include "play_keys.h"
#include "selection_drawing.h"
#include "shape_drawing.h"
#include "tile_drawing.h"

namespace talus {
namespace {

// The topmost body at a point, with some tolerance for the hand; 0 if there is none.
int body_at(const State& state, Vec2 p, double tolerance) {
  int found = 0;
  for (const Body& body : state.bodies) {
    const Rect& b = body.box;
    if (p.x >= b.x - tolerance && p.x <= b.right() + tolerance && p.y >= b.y - tolerance &&
        p.y <= b.bottom() + tolerance)
      found = body.id;
  }
  return found;
}

std::string zoom_text(float zoom) {
  const float factor = zoom >= 1 ? zoom : 1 / zoom;
  if (factor != std::floor(factor)) return small_too(zoom) + "x";
  return (zoom >= 1 ? "" : "1/") + std::to_string(static_cast<int>(factor)) + "x";
}

// What the keyboard's cursor can do now.
std::string cursor_hint(const Ui& ui) {
  if (ui.view.canvas.cursor.pen_down())
    return "   pen down: " + keys_of("view/cursor"_command, ui) + " lifts it";
  return "   " + keys_of("cursor/press"_command, ui) + ": left button   " +
         keys_of("view/cursor"_command, ui) + ": pen down   " + keys_of("cursor/end"_command, ui) + ": end";
}

// Estimates how much of the map's drawing a box hides, at places that are close enough to miss no tile.
int tiles_below(const Level& level, const ScreenBox& box, const CanvasView& view) {
  const float step = std::clamp(view.zoom * static_cast<float>(level.map.tile_size().height) / 2, 1.0f, 4.0f);
  int count = 0;
  for (float y = box.min.y; y <= box.max.y; y += step) {
    for (float x = box.min.x; x <= box.max.x; x += step) {
      const Cell cell = view.to_cell({x, y});
      if (!level.map.contains(cell)) continue;
      const auto at = static_cast<std::size_t>(cell.y) * level.map.width() + cell.x;
      for (int layer = 0; layer < level.layers.count(); ++layer)
        if (level.cells_of(layer).tiles()[at] != 0) ++count;
    }
  }
  return count;
}

// The button that a tool is used with from this frame on.
int pressed_button(const Preferences& preferences) {
  if (middle_button_picks(preferences)) return LevelToolHand::kMiddle;
  return ImGui::IsMouseClicked(0) ? LevelToolHand::kLeft : LevelToolHand::kNoButton;
}

Rgb rgb_of(ImU32 color) {
  const auto channel = [color](int shift) { return static_cast<std::uint8_t>(color >> shift & 0xFF); };
  return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT)};
}

// What the fix under the mouse would make of the ground.
void draw_fix_preview(ImDrawList& list, const CanvasView& view, const Ui& ui) {
  const auto& preview = ui.view.canvas.fix_preview;
  if (preview == nullptr) return;
  for (const Cell cell : preview->cells)
    draw_cell_frame(list, {cell.x, cell.y, 1, 1}, view, theme::color(theme::kAccent), ui.px(1));
  draw_shapes_of(preview->cells, list, preview->level, view, theme::kAccent, ui);
}

}  // namespace

void LevelCanvas::draw(const Session& session, Actions& actions, Ui& ui, ImVec2 size) {
  size = {std::max(1.0f, std::floor(size.x)), std::max(1.0f, std::floor(size.y))};
  if (const auto keep = has_requests(ui.view) ? ui.view.requests.take<request::KeepZoom>() : std::nullopt) {
    camera_.keep(keep->on);
    followed_.reset();
  }
  start_afresh(session, ui, size);
  note_directions(session);
  take_requests(session, ui, size);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(name_.c_str(), size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.item(name_ + "/canvas");
  handle_mouse(session, actions, ui, view_at(min, size, session));
  follow_cursor(session, ui, view_at(min, size, session));
  follow_body(session, ui);
  camera_.clamp(size_in_pixels(session.level().map), size);

  const CanvasView view = view_at(min, size, session);
  ui.view.canvas.middle = view.to_cell({(view.min.x + view.max.x) / 2, (view.min.y + view.max.y) / 2});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(view.min, view.max, true);
  draw_layers(session, view, ui);
  if (is_play() && ui.view.tour.open) note_followed(session, view, ui);
  if (ui.view.canvas.marked_cell)
    draw_cell_frame(list, {ui.view.canvas.marked_cell->x, ui.view.canvas.marked_cell->y, 1, 1}, view,
                    theme::color(theme::kWarning), ui.px(2));
  draw_fix_preview(list, view, ui);
  const bool paints = this->paints(ui.view);
  if (paints && session.choices().selection) draw_selection(list, *session.choices().selection, view, ui);
  if (paints && !camera_hand_.is_moving() && !camera_.shows_whole() && !sheet_overlay_.has_mouse())
    hand_.draw(list, use(session, view, ui));
  if (is_play()) {
    if (holding_ && !session.playback().running) draw_pull(session, view, ui);
    draw_note_on_body(session, view, ui);
  }
  draw_captions(session, view, ui);
  sheet_overlay_.draw(list, session, view, ui);
  if (has_minimap(ui)) minimap_.draw(list, session.level(), view, ui, name_ + "/overview");
  ui.view.canvas.cursor.draw(name_, list, view, ui.scale);
  list.PopClipRect();
  if (is_play() && session.state().bodies.empty()) offer_player(session, view, actions, ui);
}

void LevelCanvas::draw_other_side(const Session& session, Ui& ui, ImVec2 size) {
  size = {std::max(1.0f, std::floor(size.x)), std::max(1.0f, std::floor(size.y))};
  const CanvasView view = view_at(ImGui::GetCursorScreenPos(), size, session);
  ImGui::Dummy(size);
  ui.item("play/other_side");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(view.min, view.max, true);
  const Timeline& timeline = session.timeline();
  // A variant uses the levels of the branch that is shown.
  const bool is_branch = !session.debugger().side_by_side().variant() && timeline.compared() != nullptr;
  other_level_at_frame_.show(session, is_branch ? *timeline.compared() : timeline.current(),
                             timeline.frame());
  draw_ground(session, &other_level_at_frame_, 2, view, ui);
  draw_other_bodies(list, session, other_level_at_frame_.level(session), view, ui);
  const ImVec2 at{view.min.x + ui.px(4), view.min.y + ui.px(4)};
  const std::string missing = missing_side(session);
  const std::string title = missing.empty() ? other_side_name(session) : missing;
  const float plate = ImGui::GetTextLineHeight() + ui.px(8);
  const auto then = other_level_at_frame_.is_other() ? plate_lines(other_level_at_frame_.caption(), view, ui)
                                                     : std::vector<std::string>();
  const ScreenBox covered{view.min, {view.max.x, at.y + plate * static_cast<float>(1 + then.size())}};
  draw_other_overlays(list, session, view, ui.scale, std::span(&covered, 1));
  draw_plate(list, at, title, theme::color(theme::kMuted), ui);
  for (std::size_t i = 0; i < then.size(); ++i)
    draw_plate(list, {at.x, at.y + plate * static_cast<float>(i + 1)}, then[i], theme::color(theme::kWarning),
               ui);
  list.PopClipRect();
}

// What a tool may know; the data of a drag are in its hand.
LevelToolUse LevelCanvas::use(const Session& session, const CanvasView& view, Ui& ui) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {session, ui, view, view.to_level(mouse), view.to_cell(mouse), ImGui::IsItemHovered()};
}

// Shows what matters of another level, as large as a changed window allows, until the user has chosen a view.
void LevelCanvas::start_afresh(const Session& session, const Ui& ui, ImVec2 size) {
  const bool another = level_number_ != ui.view.canvas.level_number;
  const bool resized = size.x != size_.x || size.y != size_.y;
  const bool was_compiling = std::exchange(compiling_, session.compile_progress().has_value());
  const bool has_bodies_now = was_compiling && !compiling_ && session.history().edits().empty();
  level_number_ = ui.view.canvas.level_number;
  if (resized) camera_.keep_middle(std::exchange(size_, size), size);
  if (resized) followed_.reset();  // the body stays in sight
  if (another || ((resized || has_bodies_now) && camera_.is_untouched())) show_opening(session, ui, size);
}

void LevelCanvas::show_opening(const Session& session, const Ui& ui, ImVec2 size) {
  const TileMap& map = session.level().map;
  camera_ = Camera();
  if (!ui.view.canvas.opens_on_player) return camera_.fit(size_of_screen(map), size);
  const OpeningArea shown = opening_area(session.level(), session.state());
  camera_.show(shown.area, shown.may_be_cut, shown.bounds, size);
}

// Whether the requests of the view are for this canvas, of the two that may be shown.
bool LevelCanvas::has_requests(const View& view) const {
  if (view.canvas.mode == CanvasMode::both) return view.canvas.play_active == is_play();
  return view.canvas.mode != CanvasMode::two_maps || view.canvas.second_map == is_second_;
}

void LevelCanvas::take_requests(const Session& session, Ui& ui, ImVec2 size) {
  View& v = ui.view;
  const bool mine = has_requests(v);
  const Vec2 map = size_in_pixels(session.level().map);
  camera_.limit(map, size);
  const bool centres =
      v.canvas.mode == CanvasMode::two_maps ? mine : !is_play() || v.canvas.mode == CanvasMode::play;
  if (const auto shown = centres ? v.requests.take<request::ShowCell>() : std::nullopt) {
    const Vec2 place = session.level().map.box_of(shown->cell).center();
    const bool is_in_sight = camera_.is_in_sight(place, size);
    if (!is_in_sight) camera_.leave_whole(place, size);
    if (camera_.follow(place, map, size) || !is_in_sight) let_go(ui);
  }
  if (!mine) return;
  if (const auto zoom = v.requests.take<request::Zoom>())
    camera_.zoom_at({size.x / 2, size.y / 2}, zoom->steps);
  if (const auto scroll = v.requests.take<request::Scroll>()) {
    camera_.scroll(scroll->by);
    let_go(ui);
  }
  if (v.requests.take<request::FitMap>()) camera_.toggle_whole(map, size);
  if (v.requests.take<request::ShowOpening>()) {
    show_opening(session, ui, size);
    v.canvas.follow_body = v.canvas.opens_on_player;
  }
}

void LevelCanvas::handle_mouse(const Session& session, Actions& actions, Ui& ui, const CanvasView& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  const Cell cell = view.to_cell(io.MousePos);
  if (hovered) {
    ui.view.canvas.hover.pixel = view.to_level(io.MousePos);
    if (session.level().map.contains(cell)) {
      ui.view.canvas.hover.cell = cell;
      ui.view.sprites.tile_places[session.level().map.tile_at(cell)] = cell;
    }
    camera_hand_.zoom(camera_, {io.MousePos.x - view.min.x, io.MousePos.y - view.min.y});
    if (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2) ||
        io.MouseWheel != 0) {
      ui.view.canvas.play_active = is_play();
      ui.view.canvas.second_map = is_second_;
    }
  }
  if (hovered && ImGui::IsMouseClicked(0)) {
    ui.view.canvas.marked_cell.reset();
    if (ui.view.canvas.hover.cell) ui.view.canvas.clicked_cell = cell;
  }
  const bool is_held = camera_hand_.is_moving() || holding_ || is_editing();
  if (is_play() && !is_held && legend(session, view, ui).take_mouse(ui)) return;
  if (pick_cell(session, ui, cell, hovered)) return;
  const bool paints = this->paints(ui.view);
  if (paints &&
      sheet_overlay_.update(session, actions, ui, view, hovered, is_editing() || camera_hand_.is_moving()))
    return;
  if (handle_minimap(session, view, ui, hovered)) return;
  if (handle_panning(session, ui, paints, hovered)) return;
  if (handle_world_view(session, ui, hovered)) return;
  if (paints || is_editing())
    hand_.update(use(session, view, ui), actions,
                 hovered ? pressed_button(ui.view.preferences) : LevelToolHand::kNoButton);
  else
    handle_play_mouse(session, actions, view, hovered);
}

// A breakpoint's panel asks for a cell; a click beside the map cancels.
bool LevelCanvas::pick_cell(const Session& session, Ui& ui, Cell cell, bool hovered) const {
  if (!ui.view.debugger.picks_cell || !hovered) return false;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsMouseClicked(0)) {
    ui.view.debugger.picks_cell = false;
    if (session.level().map.contains(cell)) ui.ask(request::PutBreakpointAt{cell});
  }
  return true;
}

// Only as the body moves on: in a pause the user may zoom in elsewhere, and choose or place another body.
void LevelCanvas::follow_body(const Session& session, const Ui& ui) {
  const Body* body = followed_body(session.state(), session.choices().body);
  if (body == nullptr) followed_body_ = 0;
  if (!is_play() || !ui.view.canvas.follow_body || body == nullptr) return followed_.reset();
  const std::pair now(session.state().frame, body->id);
  const bool is_paused_at = followed_ && followed_->first == now.first && !session.playback().running;
  if (holding_ || is_paused_at || followed_ == now) return;
  const Vec2 place = body->box.center();
  // Else the body would go from under the mouse that has chosen it.
  const bool is_other = std::exchange(followed_body_, body->id) != body->id;
  followed_ = now;
  waits_for_body_ = (waits_for_body_ || is_other) && camera_.is_on_canvas(place, size_) &&
                    !camera_.is_in_middle(place, size_);
  if (!waits_for_body_) camera_.follow(place, size_in_pixels(session.level().map), size_);
}

// The user has moved the view by hand.
void LevelCanvas::let_go(Ui& ui) const {
  if (is_play()) ui.view.canvas.follow_body = false;
}

// For tools that draw lines the keyboard's cursor moves from corner to corner.
void LevelCanvas::follow_cursor(const Session& session, Ui& ui, const CanvasView& view) {
  const TileMap& map = session.level().map;
  const MapTool tool = session.choices().map_tool;
  const CursorGround ground{{0, 0, static_cast<int>(map.px_width()), static_cast<int>(map.px_height())},
                            map.tile_size(),
                            tool == MapTool::slope || draws_curves(tool)};
  const auto moved = ui.view.canvas.cursor.visit(name_, view, ground, ImGui::GetIO().MousePos);
  if (moved) camera_.keep_in_sight(*moved, size_);
}

// In the world view a click goes to its place, as in TIC-80.
bool LevelCanvas::handle_world_view(const Session& session, Ui& ui, bool hovered) {
  if (!camera_.shows_whole() || is_editing()) return false;
  if (hovered && ImGui::IsMouseClicked(0)) {
    const ImVec2 mouse = ImGui::GetIO().MousePos, min = ImGui::GetItemRectMin();
    const Vec2 map = size_in_pixels(session.level().map);
    const Vec2 at = view_at(min, size_, session).to_level(mouse);
    camera_.leave_whole({std::clamp(at.x, 0.0, map.x), std::clamp(at.y, 0.0, map.y)}, size_);
    let_go(ui);
  }
  return true;
}

bool LevelCanvas::handle_minimap(const Session& session, const CanvasView& view, const Ui& ui, bool hovered) {
  if (!has_minimap(ui) || is_editing()) return false;
  std::optional<Vec2> centre;
  const bool taken =
      minimap_.update(session.level().map, view, ui,
                      hovered && !camera_hand_.is_moving() && !ui.view.canvas.cursor.on(), centre);
  if (centre) camera_.centre(*centre, size_);
  return taken;
}

bool LevelCanvas::handle_panning(const Session& session, Ui& ui, bool paints, bool hovered) {
  const bool hand =
      space_moves_view(session, ui.view) || (session.choices().map_tool == MapTool::pan && paints);
  const bool middle = !paints || !ui.view.preferences.middle_picks;
  int button = CameraHand::kNone;
  if (hand && ImGui::IsMouseClicked(0)) button = 0;
  if (ImGui::IsMouseClicked(1)) button = 1;
  if (middle && ImGui::IsMouseClicked(2)) button = 2;
  if (camera_hand_.move(camera_, hovered ? button : CameraHand::kNone)) let_go(ui);
  return camera_hand_.is_moving();
}

void LevelCanvas::handle_play_mouse(const Session& session, Actions& actions, const CanvasView& view,
                                    bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 at = view.to_level(io.MousePos);
  if (hovered && ImGui::IsMouseClicked(0)) {
    holding_ = true;
    const int id = body_at(session.state(), at, 2.0 / view.zoom);
    const Body* const body = session.state().find(id);
    grip_ = body != nullptr ? std::optional(at - body->box.position()) : std::nullopt;
    actions.push_back(action::SelectBody{id});
  }
  if (holding_ && !io.MouseDown[0]) {
    holding_ = false;
    actions.push_back(action::HoldMouse{pulled_to(session, at), false});
  }
  if (holding_) actions.push_back(action::HoldMouse{pulled_to(session, at), true});
}

// Where the mouse is for the steps, which pull a point of the body there that is `drag_offset` from its
// corner. Here it is held where it was pressed, so that a click does not move it.
Vec2 LevelCanvas::pulled_to(const Session& session, Vec2 mouse) const {
  if (!grip_) return mouse;
  const double offset = session.level().tuning.shared.drag_offset;
  return mouse - *grip_ + Vec2{offset, offset};
}

// The tour points at it.
void LevelCanvas::note_followed(const Session& session, const CanvasView& view, Ui& ui) const {
  const Body* body = followed_body(session.state(), session.choices().body);
  if (body == nullptr) return;
  ui.place(name_ + "/followed", view.to_screen({body->box.x, body->box.y}),
           view.to_screen({body->box.right(), body->box.bottom()}));
}

// A body that stands looks where it went last.
void LevelCanvas::note_directions(const Session& session) {
  if (session.state().frame == 0) looks_left_.clear();
  for (const Body& body : session.state().bodies)
    if (body.velocity.x != 0 && picture_of_body(session.level(), body) != nullptr)
      looks_left_[body.id] = body.velocity.x < 0;
}

// The level without its bodies. then: the level to show; null: the current one.
void LevelCanvas::draw_ground(const Session& session, const LevelAtFrame* then, int place,
                              const CanvasView& view, const Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool is_other = then != nullptr && then->is_other();
  const Level& level = is_other ? then->level(session) : session.level();
  const auto& tint = session.choices().flag_overlay;
  const bool far = is_far(view) && ui.map_textures != nullptr;
  if (far) {
    const OtherLevel other{&level, is_other ? then->number() : 0, place};
    list.AddRectFilled(view.min, view.max, theme::color(theme::kOutside));
    draw_far_tiles(list, level, view, ui,
                   {is_play(), tint, tint ? rgb_of(flag_color(tint->lowest_flag(), 255)) : Rgb{}}, is_play(),
                   is_other ? &other : nullptr);
  } else {
    TileLooks looks{.hide_balls = is_play(), .parallax = is_play()};
    if (is_play()) looks.time = static_cast<double>(session.timeline().frame()) * kMsPerFrame;
    draw_tiles(list, level, view, ui, looks);
  }
  if (is_other) draw_marked_cells(list, then->changed(), view);
  draw_curves(list, level, view, ui.scale);
  const bool paints = this->paints(ui.view);
  if (!level.objects.empty() && paints) draw_objects(list, level, view, ui, ImGui::GetIO().MousePos);
  if (tint && !far) draw_flag_tint(list, level, view, *tint);
}

void LevelCanvas::draw_layers(const Session& session, const CanvasView& view, const Ui& ui) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_play()) level_at_frame_.show(session, session.timeline().current(), session.timeline().frame());
  const Level& level = is_play() ? level_at_frame_.level(session) : session.level();
  const Choices& choices = session.choices();
  draw_ground(session, is_play() ? &level_at_frame_ : nullptr, 1, view, ui);
  if (choices.overlays.has(overlay::shapes))
    draw_shapes(list, level, view, overlay_color(overlay::shapes, choices.overlay_palette), ui);
  const bool paints = this->paints(ui.view);
  if (choices.grid && paints) draw_grid(list, level.map, view);
  if (choices.screen_borders && paints) draw_screen_borders(list, level.map, view, ui.scale);
  if (!is_play() || (paints && choices.map_tool == MapTool::body)) draw_spawns(list, level, view, ui);
  const bool at_start = session.state().frame == 0;
  draw_bodies(list, session, level, view, ui, is_play() || at_start ? 255 : 130, looks_left_);
  if (!is_play()) return;
  const Vec2 mouse = view.to_level(ImGui::GetIO().MousePos);
  const int pointed_at = ImGui::IsItemHovered() ? body_at(session.state(), mouse, 2.0 / view.zoom) : 0;
  if (!ui.view.canvas.split_compared) draw_ghosts(list, session, view, ui.scale);
  std::vector<ScreenBox> covered{captions_box(session, view, ui)};
  if (const auto legend = this->legend(session, view, ui).box()) covered.push_back(*legend);
  OverlaySet overlays = choices.overlays;
  if (ui.view.canvas.hovered_overlay != nullptr) overlays.set(*ui.view.canvas.hovered_overlay, true);
  draw_overlays(
      list, session, overlays, view, ui.scale,
      {pointed_at, ui.view.canvas.labels_all, ui.view.debugger.shown_stage(ImGui::GetFrameCount()), covered});
  const bool another_holds = session.state().grabbed != 0 && !holding_;
  if (shows_input_roll(ui.view) || another_holds) draw_mouse_mark(list, session, view, ui);
}

// A plate above the body that the user looks at, or in the middle if it is out of sight.
void LevelCanvas::draw_note_on_body(const Session& session, const CanvasView& view, Ui& ui) const {
  const Body* const held = session.state().find(session.state().grabbed);
  const Body* const body = held != nullptr ? held : followed_body(session.state(), session.choices().body);
  const std::string text = body != nullptr ? body_note(*body, holding_, session, ui) : "";
  if (text.empty()) return;
  const ImVec2 top = view.to_screen({body->box.center().x, body->box.y});
  const float gap = ui.px(4);
  const ImVec2 size = size_of_plate(text, ui);
  const auto within = [](float at, float least, float most) { return std::max(least, std::min(at, most)); };
  const float highest = captions_box(session, view, ui).max.y + gap;
  ImVec2 at{within(top.x - size.x / 2, view.min.x + gap, view.max.x - size.x - gap),
            within(top.y - size.y - 3 * gap, highest, view.max.y - size.y - gap)};
  const bool is_in_sight =
      top.x >= view.min.x && top.x <= view.max.x && top.y >= view.min.y && top.y <= view.max.y;
  if (!is_in_sight) at = {(view.min.x + view.max.x - size.x) / 2, (highest + view.max.y - size.y) / 2};
  draw_plate(*ImGui::GetWindowDrawList(), at, text, theme::color(theme::kText), ui);
  ui.place(name_ + "/body_note", at, {at.x + size.x, at.y + size.y});
}

// A line to where a held ball is pulled.
void LevelCanvas::draw_pull(const Session& session, const CanvasView& view, const Ui& ui) const {
  const Body* body = session.state().find(session.state().grabbed);
  if (body == nullptr) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 from = view.to_screen(grip_ ? body->box.position() + *grip_ : body->box.center());
  const ImVec2 to = ImGui::GetIO().MousePos;
  list.AddLine(from, to, theme::color(theme::kDark, 200), ui.px(2) + 2);
  list.AddLine(from, to, theme::color(theme::kAccent), ui.px(2));
  list.AddCircleFilled(to, ui.px(3), theme::color(theme::kAccent));
}

// Plates below one another in the top left corner; in the world view in the bottom left one, where they hide
// less.
std::vector<LevelCanvas::Caption> LevelCanvas::captions(const Session& session, const CanvasView& view,
                                                        const Ui& ui) const {
  std::string title = std::string(is_play()    ? "Play"
                                  : is_second_ ? "Second map"
                                               : "Map") +
                      "  " + zoom_text(view.zoom);
  if (camera_.shows_whole()) title += "   click: go there";
  if (ui.view.canvas.cursor.is_on(name_)) title += cursor_hint(ui);
  std::vector<Caption> captions;
  const auto add = [&](const std::string& text, const auto& color) {
    for (std::string& line : plate_lines(text, view, ui)) captions.push_back({std::move(line), color});
  };
  if (!is_play()) {
    add(title, theme::kMuted);
    return captions;
  }
  if (is_compared(session)) {
    const std::string missing = missing_side(session);
    title += "   " + shown_side_name(session);
    if (!ui.view.canvas.split_compared)
      title += "   ghosts: " + (missing.empty() ? other_side_name(session) : missing);
  }
  if (keys_steer(session, ui.view)) title += "   " + play_keys_text(ui.view.preferences.keys);
  add(title, theme::kMuted);
  if (const std::string note = case_note(session); !note.empty()) add(note, theme::kMuted);
  if (level_at_frame_.is_other()) add(level_at_frame_.caption(), theme::kWarning);
  return captions;
}

ScreenBox LevelCanvas::captions_box(const Session& session, const CanvasView& view, const Ui& ui) const {
  const float gap = ui.px(4), line = ImGui::GetTextLineHeight() + ui.px(4) + gap;
  ScreenBox box{view.min, view.min};
  for (const Caption& caption : captions(session, view, ui)) {
    const float width = size_of_plate(caption.text, ui).x;
    box.max = {std::max(box.max.x, view.min.x + gap + width), box.max.y + line};
  }
  if (!camera_.shows_whole()) return box;
  const float flags = session.choices().flag_overlay ? line : 0;  // tinted cells, below
  const float down = view.max.y - box.max.y - gap - flags;
  const ScreenBox low{{box.min.x, box.min.y + down}, {box.max.x, box.max.y + down}};
  const Level& level = session.level();
  return tiles_below(level, low, view) < tiles_below(level, box, view) ? low : box;
}

// Beside the captions, or below them if there is no room.
OverlayLegend LevelCanvas::legend(const Session& session, const CanvasView& view, const Ui& ui) const {
  const ScreenBox captions = captions_box(session, view, ui);
  const bool beside =
      captions.min.y > view.min.y || captions.max.x + OverlayLegend::width(session, ui) <= view.max.x;
  return {session, view, beside ? view.min.y : captions.max.y, ui};
}

void LevelCanvas::draw_captions(const Session& session, const CanvasView& view, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float gap = ui.px(4);
  const ScreenBox box = captions_box(session, view, ui);
  ui.place(name_ + "/captions", box.min, box.max);
  float at = box.min.y + gap;
  for (const Caption& caption : captions(session, view, ui)) {
    draw_plate(list, {view.min.x + gap, at}, caption.text, theme::color(caption.color), ui);
    at += gap + ImGui::GetTextLineHeight() + ui.px(4);
  }
  if (is_play()) legend(session, view, ui).draw(list);
  if (const auto pattern = session.choices().flag_overlay) {
    const bool paints = this->paints(ui.view);
    const std::string hint = paints ? hand_.hint(use(session, view, ui)) : std::string();
    const std::string text = hint.empty() ? "tinted: " + pattern_label(session.level(), *pattern) : hint;
    draw_low_plates(list, view, text, gap, false, flag_color(pattern->lowest_flag(), 255), ui);
  }
}

bool LevelCanvas::has_ground_tiles(const Session& session) {
  if (looked_for_ground_at_ == session.revision()) return has_ground_tiles_;
  looked_for_ground_at_ = session.revision();
  const std::vector<LayerCells> layers = ground_layers(session.level());
  has_ground_tiles_ = std::ranges::any_of(layers, [](LayerCells cells) {
    return std::ranges::any_of(cells->tiles(), [](TileNumber tile) { return tile != 0; });
  });
  return has_ground_tiles_;
}

// A child has the mouse before the canvas below it.
void LevelCanvas::offer_player(const Session& session, const CanvasView& view, Actions& actions, Ui& ui) {
  // Without ground a player would only fall.
  const bool is_empty = session.level().curves.empty() && !has_ground_tiles(session);
  const std::string text =
      is_empty ? "Nothing is here yet: draw a tile, make it solid under Flags, and paint with it"
               : "No body yet: paint a tile that has the ball flag, or place one with the body tool (" +
                     keys_of("map/body"_command, ui) + ")";
  const float low = ui.px(10), height = ImGui::GetFrameHeight();
  draw_low_plates(*ImGui::GetWindowDrawList(), view, text, low + height + ui.px(8), true,
                  theme::color(theme::kText), ui);
  const CommandId offered = is_empty ? "file/new_sized"_command : "player/place"_command;
  const Command& place = find_command(offered);
  const float width = ImGui::CalcTextSize(place.label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  if (width > view.max.x - view.min.x) return;
  const ImVec2 before = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({(view.min.x + view.max.x - width) / 2, view.max.y - low - height});
  ImGui::BeginChild((name_ + "_offer").c_str(), {width, height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
  command_text_button(offered, session, actions, ui,
                      {.widget = name_ + (is_empty ? "/new_level" : "/place_player")});
  ImGui::EndChild();
  ImGui::SetCursorScreenPos(before);
}

}  // namespace talus
