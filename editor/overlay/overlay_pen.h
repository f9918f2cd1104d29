// OverlayPen draws for an overlay in the overlay's colour, in level pixels.
#pragma once

#include <algorithm>
#include <string>

#include "collision/ground_queries.h"
#include "overlay.h"
#include "visible.h"

namespace talus {

// It leaves out things that are not visible.
class OverlayPen {
 public:
  // chosen_body: id of the body whose labels come first; 0: no body.
  OverlayPen(const Overlay& overlay, Rect visible, OverlayDrawing& out, int chosen_body = 0)
      : overlay_(overlay), visible_(visible), out_(out), chosen_(chosen_body) {}

  const Rect& visible() const { return visible_; }
  OverlayDrawing& drawing() { return out_; }
  bool sees(const Rect& box) const { return meet(box, visible_); }

  // strength, detail: as in OverlayLine.
  void line(Vec2 from, Vec2 to, bool arrow = false, double strength = 1, bool detail = false) {
    if (meets(from, to, visible_)) out_.lines.push_back({&overlay_, from, to, arrow, strength, detail});
  }
  void box(const Rect& r, bool filled = false, double strength = 1) {
    if (sees(r)) out_.boxes.push_back({&overlay_, r, filled, strength});
  }
  void mark(Vec2 at) {
    if (sees({at.x, at.y, 0, 0})) out_.marks.push_back({&overlay_, at});
  }
  void bar(const Rect& r, double fraction) {  // 0 to 1
    if (sees(r)) out_.bars.push_back({&overlay_, r, fraction});
  }
  void label(Vec2 at, std::string text, const Body& body) {
    if (sees(body.box))
      out_.labels.push_back({&overlay_, at, std::move(text), body.id == chosen_, body.id, body.box});
  }

 private:
  const Overlay& overlay_;
  const Rect visible_;
  OverlayDrawing& out_;
  const int chosen_;
};

// The work that an overlay may spend on queries of the ground about a body. The chosen body always has some.
class BodyWork {
 public:
  BodyWork(OverlayDrawing& drawing, bool is_chosen)
      : drawing_(drawing),
        given_(is_chosen ? 8 * kMaxQueryWork : std::clamp<std::int64_t>(drawing.work_left, 0, kMaxQueryWork)),
        budget_{given_} {}
  ~BodyWork() {
    drawing_.work_left -= given_ - budget_.left;
    drawing_.is_cut = drawing_.is_cut || budget_.left <= 0;
  }
  BodyWork(const BodyWork&) = delete;
  BodyWork& operator=(const BodyWork&) = delete;

  bool is_left() const { return budget_.left > 0; }
  CastBudget* budget() { return &budget_; }

 private:
  OverlayDrawing& drawing_;
  const std::int64_t given_;
  CastBudget budget_;
};

}  // namespace talus
