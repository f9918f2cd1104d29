#include "stage_drawing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "number_label.h"
#include "visible.h"

namespace talus {
namespace {

constexpr double kStageNormalLength = 10;    // px
constexpr std::size_t kMaxVisited = 10'000;  // boxes; a step may pass thousands of bodies

class StageDrawer {
 public:
  StageDrawer(const Stage& stage, int body, const StepRecord& record, TileSize tile, Rect visible,
              OverlayDrawing& out)
      : stage_(stage), body_(body), record_(record), tile_(tile), visible_(visible), out_(out) {}

  void draw() {
    out_.boxes.push_back({&overlay::swept_path, stage_.box});
    switch (stage_.kind) {
      case StageKind::wanted:
      case StageKind::went_on:
      case StageKind::snapped:
        draw_motion();
        break;
      case StageKind::searched:
        draw_motion();
        draw_search();
        break;
      case StageKind::met:
        draw_contact();
        break;
      case StageKind::placed:
      case StageKind::arrived:
        out_.boxes.back().filled = true;
        break;
    }
  }

 private:
  void draw_motion() {
    if (stage_.motion == Vec2{}) return;
    const Rect& b = stage_.box;
    const Rect there{b.x + stage_.motion.x, b.y + stage_.motion.y, b.w, b.h};
    out_.lines.push_back({&overlay::swept_path, b.center(), there.center(), true});
    if (stage_.kind != StageKind::snapped) out_.boxes.push_back({&overlay::swept_path, there});
  }

  void draw_search() {
    add_visited({&stage_, 1}, tile_, visible_, out_);
    for (const CastCandidate& c : stage_.candidates) {
      const bool is_met = std::isfinite(c.t);
      out_.lines.push_back({.overlay = c.is_first ? &overlay::touch_points : &overlay::outline,
                            .from = c.from,
                            .to = c.to,
                            .strength = is_met ? 1.0 : 0.5});
      if (is_met) label((c.from + c.to) * 0.5, "t " + two_decimals(c.t));
    }
  }

  void draw_contact() {
    draw_motion();
    const ContactRecord& contact = record_.contacts[static_cast<std::size_t>(stage_.contact)];
    const Rect there{contact.touch.x, contact.touch.y, stage_.box.w, stage_.box.h};
    out_.boxes.push_back({&overlay::touch_points, there});
    const Vec2 normal = contact.slope ? contact.slope->normal : contact.normal;
    if (normal != Vec2{})
      out_.lines.push_back(
          {&overlay::normals, there.center(), there.center() + normal * kStageNormalLength, true});
    label({there.right(), there.y}, time_label(contact.ti, contact.overlaps));
  }

  void label(Vec2 at, std::string text) {
    out_.labels.push_back({&overlay::touch_points, at, std::move(text), true, body_, stage_.box});
  }

  const Stage& stage_;
  const int body_;
  const StepRecord& record_;
  TileSize tile_;
  const Rect visible_;
  OverlayDrawing& out_;
};

}  // namespace

void add_visited(std::span<const Stage> stages, TileSize tile, Rect visible, OverlayDrawing& drawing) {
  std::set<std::tuple<double, double, double, double>> seen;
  const auto add = [&](const Rect& box) {
    if (!meet(box, visible)) return;
    if (seen.size() == kMaxVisited) {
      drawing.is_cut = true;
      return;
    }
    if (!seen.emplace(box.x, box.y, box.w, box.h).second) return;
    drawing.boxes.push_back({&overlay::tested_tiles, box, true});
  };
  for (const Stage& stage : stages) {
    for (const Cell cell : stage.cells)
      add({1.0 * cell.x * tile.width, 1.0 * cell.y * tile.height, 1.0 * tile.width, 1.0 * tile.height});
    for (const Obstacle& tested : stage.tested) add(tested.box);
  }
}

void add_stage(const Stage& stage, int body, const StepRecord& record, TileSize tile, Rect visible,
               OverlayDrawing& drawing) {
  StageDrawer(stage, body, record, tile, visible, drawing).draw();
}

}  // namespace talus
