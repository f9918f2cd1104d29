// Draws the chosen overlays, the lowest layer first.
#include "overlay.h"

#include <algorithm>
#include <iterator>

#include "debug/metrics.h"
#include "overlay_pen.h"

namespace talus {
namespace {

class Drawer {
 public:
  Drawer(const OverlaySource& source, OverlaySet overlays, Rect visible)
      : source_(source), visible_(visible) {
    for (const Overlay* overlay : all_overlays())
      if (overlays.has(*overlay)) overlays_.push_back(overlay);
    std::stable_sort(overlays_.begin(), overlays_.end(),
                     [](const Overlay* a, const Overlay* b) { return a->layer < b->layer; });
  }

  OverlayDrawing draw() {
    const auto above = std::find_if(overlays_.begin(), overlays_.end(),
                                    [](const Overlay* overlay) { return overlay->layer >= 0; });
    draw_whole({overlays_.begin(), above});
    for (const Body& body : source_.state.bodies)
      each(&Overlay::draw_body, [&](auto* drawn_by, OverlayPen& pen) { drawn_by(source_, body, pen); });
    for (const ContactRecord& contact : source_.record.contacts) {
      // An edit may have removed the body since the step.
      if (const Body* body = source_.state.find(contact.body))
        each(&Overlay::draw_contact,
             [&](auto* drawn_by, OverlayPen& pen) { drawn_by(source_, contact, *body, pen); });
    }
    draw_probes();
    draw_whole({above, overlays_.end()});
    return std::move(out_);
  }

 private:
  // Calls `call` with each function of this kind that the overlays have.
  template <class Member, class Call>
  void each(Member member, Call call) {
    for (const Overlay* overlay : overlays_) {
      if (overlay->*member == nullptr) continue;
      OverlayPen pen(*overlay, visible_, out_, source_.chosen_body);
      call(overlay->*member, pen);
    }
  }

  void draw_whole(std::span<const Overlay* const> overlays) {
    for (const Overlay* overlay : overlays) {
      OverlayPen pen(*overlay, visible_, out_, source_.chosen_body);
      if (overlay->draw != nullptr) overlay->draw(source_, pen);
    }
  }

  // A body may search a floor at several contacts of a step. The last search decided its place.
  void draw_probes() {
    const std::vector<Body>& bodies = source_.state.bodies;
    std::vector<const SlopeProbe*> last(bodies.size());
    for (const ContactRecord& contact : source_.record.contacts) {
      const Body* body = source_.state.find(contact.body);
      if (body != nullptr && contact.slope) last[body - bodies.data()] = &*contact.slope;
    }
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (last[i] != nullptr)
        each(&Overlay::draw_probe,
             [&](auto* drawn_by, OverlayPen& pen) { drawn_by(source_, *last[i], bodies[i], pen); });
    }
  }

  const OverlaySource& source_;
  const Rect visible_;
  std::vector<const Overlay*> overlays_;  // the chosen ones, by layer
  OverlayDrawing out_;
};

// The part of a source that is drawn of very many bodies: the chosen one, and the first ones in view.
class ManyBodies {
 public:
  ManyBodies(const OverlaySource& whole, OverlaySet overlays, Rect visible) : whole_(whole) {
    for (const Body& body : whole.state.bodies) {
      if (body.id != whole.chosen_body && !is_seen(body, visible)) continue;
      if (body.id == whole.chosen_body || state_.bodies.size() < kMaxDrawnBodies)
        state_.bodies.push_back(body);
      else
        is_cut_ = true;
      if (is_cut_ && body.id > whole.chosen_body) break;
    }
    state_.frame = whole.state.frame;
    state_.grabbed = whole.state.grabbed;
    state_.next_id = whole.state.next_id;
    keep(whole.record.paths, record_.paths);
    keep(whole.record.contacts, record_.contacts);
    if (overlays.has(overlay::tested_tiles)) keep(whole.record.tested, record_.tested);
    record_.work = whole.record.work;
  }

  bool is_cut() const { return is_cut_; }  // whether bodies in view are left out
  OverlaySource source() const {
    return {.scene = whole_.scene,
            .state = state_,
            .record = record_,
            .ground = whole_.ground,
            .chosen_body = whole_.chosen_body,
            .level = whole_.level,
            .hard_case = whole_.hard_case,
            .reach = whole_.reach,
            .reach_is_stale = whole_.reach_is_stale,
            .proof = whole_.proof,
            .trails = whole_.trails,
            .stages = whole_.stages};
  }

 private:
  // Whether the body, its velocity or its last path may be seen.
  bool is_seen(const Body& body, Rect visible) const {
    const Vec2 from = body.box.center();
    if (meet(body.box, visible) || meets(from, from + body.velocity * kPixelsPerVelocity, visible))
      return true;
    const BodyPath* path = path_of(whole_.record, body.id);
    return path != nullptr &&
           (meet(path->from, visible) || meets(path->from.center(), path->to.center(), visible));
  }

  template <class Entry>
  void keep(const std::vector<Entry>& all, std::vector<Entry>& kept) const {
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept),
                 [this](const Entry& entry) { return state_.find(entry.body) != nullptr; });
  }

  const OverlaySource& whole_;
  State state_;
  StepRecord record_;
  bool is_cut_ = false;
};

}  // namespace

OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible) {
  if (source.state.bodies.size() <= kMaxDrawnBodies) return Drawer(source, overlays, visible).draw();
  const ManyBodies many(source, overlays, visible);
  const OverlaySource part = many.source();
  OverlayDrawing drawing = Drawer(part, overlays, visible).draw();
  drawing.is_cut = drawing.is_cut || many.is_cut();
  return drawing;
}

}  // namespace talus
