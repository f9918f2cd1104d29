// Draws the chosen overlays, the lowest layer first.
#include "overlay.h"

#include <algorithm>

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

}  // namespace

OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible) {
  return Drawer(source, overlays, visible).draw();
}

}  // namespace talus
