#include "other_side.h"

#include <algorithm>

#include "canvas_layers.h"
#include "debug/stages.h"
#include "overlay_painter.h"
#include "panels/debugger/compare_choice.h"

namespace talus {
namespace {

std::vector<ColoredTrails> other_trails(const Session& session, int chosen) {
  const std::int64_t frame = session.timeline().frame();
  const std::int64_t first = std::max<std::int64_t>(frame - kTrailFrames, 0);
  if (first == frame) return {};
  std::vector<int> bodies{chosen};
  if (session.choices().body == 0) {
    bodies.clear();
    for (const Body& body : session.other_state()->bodies)
      if (bodies.size() < kMaxTrails) bodies.push_back(body.id);
  }
  std::vector<Trail> trails;
  for (const int body : bodies) {
    Trail& trail = trails.emplace_back();
    for (const TrailPoint& point : session.other_trail(body, first, frame))
      trail.push_back(point.box.center());
  }
  return {{std::move(trails), &overlay::trails}};
}

}  // namespace

std::string shown_side_name(const Session& session) {
  if (!compare_choice(session).variant) return "branch " + std::to_string(session.timeline().current().id);
  const Tuning& tuning = session.scene().tuning;
  const bool single = tuning.solver == SolverKind::exact && tuning.exact.single_precision != 0;
  return std::string(solver_name(tuning.solver)) + (single ? ", single precision" : "");
}

std::string other_side_name(const Session& session) { return compare_choice(session).label; }

int chosen_on_other_side(const Session& session) {
  const State* other = session.other_state();
  const int chosen = session.choices().body;
  if (other == nullptr || chosen == 0) return 0;
  const auto bodies = differences(session.state(), *other);
  const auto at =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodyDifference& d) { return d.a == chosen; });
  return at != bodies.end() ? at->b : 0;
}

void draw_other_bodies(ImDrawList& list, const Session& session, const Level& level, const CanvasView& view,
                       const Ui& ui) {
  if (const State* other = session.other_state())
    draw_state(list, *other, chosen_on_other_side(session), level, view, ui, 255);
}

void draw_other_overlays(ImDrawList& list, const Session& session, const CanvasView& view, float scale,
                         std::span<const ScreenBox> covered) {
  const OverlaySet overlays = drawable_overlays(session.choices().overlays, view);
  const Frame* frame = overlays.empty() ? nullptr : session.other_frame();
  if (frame == nullptr) return;
  const int chosen = chosen_on_other_side(session);
  OverlayDrawing drawing = make_overlays(with_level({.scene = *frame->scene,
                                                     .state = frame->state,
                                                     .record = frame->record,
                                                     .ground = frame->ground.get(),
                                                     .chosen_body = chosen,
                                                     .trails = [&] { return other_trails(session, chosen); },
                                                     .stages = [&] { return stages_of(*frame, chosen); }},
                                                    session),
                                         overlays, view.visible());
  drawing.palette = session.choices().overlay_palette;
  paint_overlays(list, drawing, label_obstacles(*frame->scene, frame->state, view, covered), view, scale, 0);
}

}  // namespace talus
