// Draws the layers of a canvas.
#include "canvas_layers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "body_drawing.h"
#include "overlay/outline.h"
#include "overlay/stage_drawing.h"
#include "overlay/visible.h"
#include "overlay/visible_items.h"
#include "overlay_painter.h"
#include "session/checks/prover.h"
#include "session/run/scene_compiler.h"
#include "tile_drawing.h"
#include "turned_tile.h"

namespace talus {
namespace {

constexpr float kLeastScreen = 16;    // px of the screen: closer borders would cover everything
constexpr double kSamePlace = 0.005;  // px: closer bodies hide one another

}  // namespace

void draw_curves(ImDrawList& list, const Level& level, const CanvasView& view, float scale) {
  if (level.curves.empty()) return;
  const std::vector<CurveLine> lines = curve_lines(level, view.visible());
  const float width = std::max(1.0f, std::round(scale * 2));
  const bool counts = level.tuning.solver == SolverKind::exact;
  const auto stroke = [&](ImU32 color, float of_width) {
    for (const CurveLine& line : lines)
      list.AddLine(view.to_screen(line.from), view.to_screen(line.to), color, of_width);
  };
  stroke(theme::color(theme::kDark), width + 2);
  stroke(theme::color(counts ? theme::kText : theme::kMuted), width);
}

ImU32 flag_color(int flag, int alpha) {
  constexpr std::array<std::uint32_t, kCartFlags> kColors = {0xff6188, 0xffd866, 0x78dce8, 0xab9df2,
                                                             0xa9dc76, 0xfc9867, 0x66d9c0, 0xd0d0d0};
  return theme::color(kColors[static_cast<std::size_t>(flag % kCartFlags)], alpha);
}

void draw_flag_tint(ImDrawList& list, const Level& level, const CanvasView& view, FlagPattern pattern) {
  const int flag = pattern.lowest_flag();
  const CellSpan cells = visible_cells(level.map, view);
  std::vector<LayerCells> layers = ground_layers(level);
  if (!level.layers.list[static_cast<std::size_t>(level.layers.chosen)].is_ground)
    layers.push_back(&level.map.cells());
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const auto at = static_cast<std::size_t>(y) * level.map.width() + x;
      const bool matches = std::any_of(layers.begin(), layers.end(), [&](LayerCells tiles) {
        return pattern.matches(level.tile_flags(tiles->tiles()[at]));
      });
      if (!matches) continue;
      const ImVec2 from = view.corner_of({x, y}), to = view.corner_of({x + 1, y + 1});
      list.AddRectFilled(from, to, flag_color(flag, 110));
      if (view.zoom >= 2) list.AddRect(from, to, flag_color(flag, 220));
    }
  }
}

void draw_grid(ImDrawList& list, const TileMap& map, const CanvasView& view) {
  if (view.zoom < 2) return;  // lines would cover everything
  const CellSpan cells = visible_cells(map, view);
  const ImU32 color = theme::color(theme::kText, 26);
  const ImVec2 from = view.corner_of({cells.x0, cells.y0}), to = view.corner_of({cells.x1, cells.y1});
  for (int x = cells.x0; x <= cells.x1; ++x) {
    const float sx = view.corner_of({x, 0}).x;
    list.AddRectFilled({sx, from.y}, {sx + 1, to.y}, color);
  }
  for (int y = cells.y0; y <= cells.y1; ++y) {
    const float sy = view.corner_of({0, y}).y;
    list.AddRectFilled({from.x, sy}, {to.x, sy + 1}, color);
  }
}

void draw_screen_borders(ImDrawList& list, const TileMap& map, const CanvasView& view, float scale) {
  if (static_cast<float>(kScreenRows * view.tile.height) * view.zoom < kLeastScreen) return;
  const float width = std::max(1.0f, std::round(scale));
  const ImU32 color = theme::color(theme::kAccent, 150);
  const CellSpan cells = visible_cells(map, view);
  const ImVec2 from = view.corner_of({cells.x0, cells.y0}), to = view.corner_of({cells.x1, cells.y1});
  // Only TIC-80's tiles make its screens.
  const bool has_screens = view.tile == TileSize{kCartTileSize, kCartTileSize};
  const int columns = has_screens ? kScreenColumns : map.width(),
            rows = has_screens ? kScreenRows : map.height();
  // Draws the borders between the columns, or rows, from the first to the last: those of screens, and the
  // map's own end.
  const auto draw = [](int first, int last, int screen, int end, const auto& line) {
    for (int at = (first + screen - 1) / screen * screen; at <= last; at += screen) line(at);
    if (last == end && end % screen != 0) line(end);
  };
  draw(cells.x0, cells.x1, columns, map.width(), [&](int x) {
    const float sx = view.corner_of({x, 0}).x;
    list.AddRectFilled({sx, from.y}, {sx + width, to.y}, color);
  });
  draw(cells.y0, cells.y1, rows, map.height(), [&](int y) {
    const float sy = view.corner_of({0, y}).y;
    list.AddRectFilled({from.x, sy}, {to.x, sy + width}, color);
  });
}

void draw_spawns(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui) {
  const Rect visible = view.visible();
  for (const Spawn& spawn : level.spawns) {
    const Rect box{spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y};
    if (!meet(box, visible)) continue;
    const ImVec2 from = view.to_screen({box.x, box.y}), to = view.to_screen({box.right(), box.bottom()});
    list.AddRect(from, to, theme::color(theme::kDark, 200), 0, 0, ui.px(1) + 2);
    list.AddRect(from, to, theme::color(theme::kMuted), 0, 0, ui.px(1));
  }
}

void draw_bodies(ImDrawList& list, const Session& session, const Level& level, const CanvasView& view,
                 const Ui& ui, int alpha, const std::unordered_map<int, bool>& looks_left) {
  draw_state(list, session.state(), session.choices().body, level, view, ui, alpha, looks_left);
}

void draw_state(ImDrawList& list, const State& state, int chosen_body, const Level& level,
                const CanvasView& view, const Ui& ui, int alpha,
                const std::unordered_map<int, bool>& looks_left) {
  const Rect visible = view.visible();
  const BodyDrawing drawing(level, state.frame);
  for (const Body& body : state.bodies) {
    if (!meet(body.box, visible)) continue;
    const auto known = looks_left.find(body.id);
    const bool is_left = known != looks_left.end() ? known->second : body.velocity.x < 0;
    drawing.draw(list, body, is_left, view, ui, alpha);
  }
  if (const Body* chosen = state.find(chosen_body)) {
    const float gap = ui.px(2);
    ImVec2 from = view.to_screen({chosen->box.x, chosen->box.y});
    ImVec2 to = view.to_screen({chosen->box.right(), chosen->box.bottom()});
    from = {from.x - gap, from.y - gap};
    to = {to.x + gap, to.y + gap};
    list.AddRect(from, to, theme::color(theme::kDark, 200), 0, 0, ui.px(1) + 2);
    list.AddRect(from, to, theme::color(theme::kAccent), 0, 0, ui.px(1));
  }
}

void draw_ghosts(ImDrawList& list, const Session& session, const CanvasView& view, float scale) {
  const State* other = session.other_state();
  if (other == nullptr) return;
  const float width = std::max(1.0f, std::round(scale));
  for (const BodyDifference& body : differences(session.state(), *other)) {
    if (body.b == 0 || body.distance < kSamePlace) continue;
    const Rect& box = other->find(body.b)->box;
    if (!meet(box, view.visible())) continue;
    const ImVec2 from = view.to_screen({box.x, box.y}), to = view.to_screen({box.right(), box.bottom()});
    list.AddRectFilled(from, to, theme::color(theme::kText, 45));
    list.AddRect(from, to, theme::color(theme::kDark, 200), 0, 0, width + 2);
    list.AddRect(from, to, theme::color(theme::kText, 220), 0, 0, width);
    if (const Body* ours = session.state().find(body.a))
      list.AddLine(view.to_screen(ours->box.center()), view.to_screen(box.center()),
                   theme::color(theme::kText, 150), width);
  }
}

namespace {

// The last frames of the chosen body or, if none is chosen, of the first few.
std::vector<Trail> trails_of(const Session& session, const Branch& branch, std::int64_t first,
                             std::int64_t last) {
  std::vector<int> bodies{session.choices().body};
  if (bodies[0] == 0) {
    bodies.clear();
    for (const Body& body : session.state().bodies)
      if (bodies.size() < kMaxTrails) bodies.push_back(body.id);
  }
  std::vector<Trail> trails;
  for (const int body : bodies) {
    Trail& trail = trails.emplace_back();
    for (const TrailPoint& point : session.trail(branch, body, first, last))
      trail.push_back(point.box.center());
  }
  return trails;
}

std::vector<ColoredTrails> all_trails(const Session& session) {
  const Timeline& timeline = session.timeline();
  const std::int64_t frame = timeline.frame(), first = std::max<std::int64_t>(frame - kTrailFrames, 0);
  const Branch* compared = timeline.compared();
  // The other side is drawn ahead, too, so that one sees where the two part.
  const std::int64_t last = compared != nullptr ? frame + kTrailFrames : frame;
  std::vector<ColoredTrails> all;
  const auto add = [&](const Branch& branch, const Overlay& color) {
    const std::int64_t end = std::min(last, branch.run_frame());
    if (first < end) all.push_back({trails_of(session, branch, first, end), &color});
  };
  if (compared != nullptr) add(*compared, overlay::tested_tiles);
  add(timeline.current(), overlay::trails);
  return all;
}

// The ground of the level there, whatever the solver; null if no overlay needs it and the solver has none.
// Large levels are not compiled only for the overlays, as each edit would take seconds.
std::shared_ptr<const Terrain> ground_for(const Session& session, OverlaySet overlays) {
  if (session.scene().ground || SceneCompiler::is_large(session.level())) return session.scene().ground;
  return overlays.any(&Overlay::needs_ground) ? session.ground() : nullptr;
}

}  // namespace

OverlaySet drawable_overlays(OverlaySet overlays, const CanvasView& view) {
  if (is_far(view)) {  // only lines of the ground would be visible, and millions of them
    for (const Overlay* overlay : all_overlays())
      if (overlay->near_only) overlays.set(*overlay, false);
  }
  return overlays;
}

std::vector<Rect> label_obstacles(const Scene& scene, const State& state, const CanvasView& view,
                                  std::span<const ScreenBox> covered) {
  std::vector<Rect> obstacles;
  const Rect visible = view.visible();
  for (const Body& body : state.bodies) {
    if (obstacles.size() == kMaxDrawnBodies) break;
    if (meet(body.box, visible)) obstacles.push_back(body.box);
  }
  for (const ScreenBox& box : covered) {
    const Vec2 from = view.to_level(box.min), to = view.to_level(box.max);
    obstacles.push_back({from.x, from.y, to.x - from.x, to.y - from.y});
  }
  if (is_far(view)) return obstacles;  // there are no labels that need room, and millions of items
  for_each_visible_item(scene, visible, [&](const SceneItem& item) {
    const bool slope = item.role == TileRole::up_slope || item.role == TileRole::down_slope;
    if (slope) obstacles.push_back(item.box);
  });
  return obstacles;
}

OverlaySource with_level(OverlaySource source, const Session& session) {
  source.level = &session.level();
  source.hard_case = session.hard_case() ? &*session.hard_case() : nullptr;
  source.reach = session.reach().found();
  source.reach_is_stale = session.reach().is_stale();
  source.proof = session.prover().found();
  return source;
}

namespace {

constexpr std::size_t kFewBodies = 2;  // so many have room for all of their labels

// Labels that belong to no body stay.
void keep_labels_of(int chosen, int pointed_at, OverlayDrawing& drawing) {
  std::erase_if(drawing.labels, [&](const OverlayLabel& label) {
    return label.body != 0 && label.body != chosen && label.body != pointed_at;
  });
}

}  // namespace

void draw_overlays(ImDrawList& list, const Session& session, OverlaySet overlays, const CanvasView& view,
                   float scale, const OverlayOptions& options) {
  const auto stage = static_cast<std::size_t>(options.stage);
  const bool has_stage = options.stage >= 0 && stage < session.stages().size();
  overlays = drawable_overlays(overlays, view);
  if (overlays.empty() && !has_stage) return;
  const std::shared_ptr<const Terrain> ground = ground_for(session, overlays);
  OverlayDrawing drawing = make_overlays(with_level({.scene = session.scene(),
                                                     .state = session.state(),
                                                     .record = session.record(),
                                                     .ground = ground.get(),
                                                     .chosen_body = session.choices().body,
                                                     .trails = [&session] { return all_trails(session); },
                                                     .stages = [&session] { return session.stages(); }},
                                                    session),
                                         overlays, view.visible());
  drawing.palette = session.choices().overlay_palette;
  if (has_stage)
    add_stage(session.stages()[stage], session.choices().body, session.record(), view.tile, view.visible(),
              drawing);
  if (!options.labels_all && session.state().bodies.size() > kFewBodies)
    keep_labels_of(session.choices().body, options.pointed_at, drawing);
  paint_overlays(list, drawing, label_obstacles(session.scene(), session.state(), view, options.covered),
                 view, scale, options.pointed_at);
}

void draw_stamp(ImDrawList& list, const Stamp& stamp, CellRect cells, const CanvasView& view, const Ui& ui,
                int alpha) {
  const Cell from = view.to_cell(view.min), to = view.to_cell(view.max);
  for (int y = std::max(cells.y, from.y); y <= std::min(cells.y + cells.h - 1, to.y); ++y) {
    for (int x = std::max(cells.x, from.x); x <= std::min(cells.x + cells.w - 1, to.x); ++x) {
      draw_map_cell(list, stamp.at((x - cells.x) % stamp.w, (y - cells.y) % stamp.h), view.tile,
                    view.corner_of({x, y}), view.corner_of({x + 1, y + 1}), ui,
                    IM_COL32(255, 255, 255, alpha));
    }
  }
}

void draw_painted_cells(ImDrawList& list, const Edit& edit, const CanvasView& view, const Ui& ui, int alpha) {
  const auto draw = [&](Cell c, MapCell content) {
    draw_map_cell(list, content, view.tile, view.corner_of({c.x, c.y}), view.corner_of({c.x + 1, c.y + 1}),
                  ui, IM_COL32(255, 255, 255, alpha));
  };
  for (const Change& change : edit.changes) {
    if (const auto* cell = std::get_if<CellChange>(&change)) draw(cell->cell, cell->after);
    const auto* whole = std::get_if<MapChange>(&change);
    if (whole == nullptr) continue;
    const CellSpan cells = visible_cells(whole->after, view);
    for (Cell c{0, cells.y0}; c.y < cells.y1; ++c.y) {
      for (c.x = cells.x0; c.x < cells.x1; ++c.x) {
        if (whole->after.at(c) != whole->before.at(c)) draw(c, whole->after.at(c));
      }
    }
  }
}

void draw_marked_cells(ImDrawList& list, std::span<const Cell> cells, const CanvasView& view) {
  const Cell from = view.to_cell(view.min), to = view.to_cell(view.max);
  for (const Cell cell : cells) {
    if (cell.x < from.x || cell.y < from.y || cell.x > to.x || cell.y > to.y) continue;
    const ImVec2 min = view.corner_of({cell.x, cell.y}), max = view.corner_of({cell.x + 1, cell.y + 1});
    list.AddRectFilled(min, max, theme::color(theme::kWarning, 60));
    if (view.zoom >= 1) list.AddRect(min, max, theme::color(theme::kWarning, 200));
  }
}

void draw_cell_frame(ImDrawList& list, CellRect cells, const CanvasView& view, ImU32 color, float width) {
  const ImVec2 from = view.corner_of({cells.x, cells.y});
  const ImVec2 to = view.corner_of({cells.x + cells.w, cells.y + cells.h});
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark, 200), 0, 0,
               width + 2);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, color, 0, 0, width);
}

}  // namespace talus
