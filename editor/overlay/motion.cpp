#include "motion.h"

#include <algorithm>
#include <vector>

#include "overlay_pen.h"

namespace talus {
namespace {

constexpr const Overlay* kPath = &overlay::swept_path;
constexpr double kFaintest = 0.15;  // strength of the oldest part of a trail

class PathDrawer {
 public:
  PathDrawer(const OverlaySource& source, Rect visible, OverlayDrawing& out)
      : source_(source), visible_(visible), out_(out) {
    for (const ContactRecord& contact : source.record.contacts)
      if (contact.handled) contacts_.push_back(&contact);
    std::stable_sort(contacts_.begin(), contacts_.end(), comes_before);
  }

  void draw(const BodyPath& path) {
    Rect at = path.from;
    if (source_.state.find(path.body) == nullptr) return;
    ghost(at);
    auto contact = std::partition_point(contacts_.begin(), contacts_.end(),
                                        [&](const ContactRecord* c) { return c->body < path.body; });
    for (; contact != contacts_.end() && (*contact)->body == path.body; ++contact)
      move_to(at, (*contact)->touch);
    move_to(at, path.to.position());
  }

 private:
  static bool comes_before(const ContactRecord* a, const ContactRecord* b) { return a->body < b->body; }
  void ghost(const Rect& box) {
    if (meet(box, visible_)) out_.boxes.push_back({kPath, box});
  }

  // The long sides of the strip are the paths of the two outermost corners across the motion.
  void move_to(Rect& at, Vec2 to) {
    const Vec2 from = at.position(), way = to - from;
    if (way == Vec2{}) return;
    at.x = to.x;
    at.y = to.y;
    const bool falls_right = (way.x < 0) == (way.y < 0);
    const Vec2 first = falls_right ? Vec2{at.w, 0} : Vec2{0, 0};
    const Vec2 second = falls_right ? Vec2{0, at.h} : Vec2{at.w, at.h};
    const Vec2 middle{at.w / 2, at.h / 2};
    line(from + first, to + first, 0.5);
    line(from + second, to + second, 0.5);
    line(from + middle, to + middle, 1);
    ghost(at);
  }

  void line(Vec2 from, Vec2 to, double strength) {
    if (meets(from, to, visible_))
      out_.lines.push_back({.overlay = kPath, .from = from, .to = to, .strength = strength});
  }

  const OverlaySource& source_;
  const Rect visible_;
  OverlayDrawing& out_;
  std::vector<const ContactRecord*> contacts_;  // handled contacts, by body and in their order
};

}  // namespace

void add_swept_paths(const OverlaySource& source, Rect visible, OverlayDrawing& drawing) {
  PathDrawer drawer(source, visible, drawing);
  for (const BodyPath& path : source.record.paths) drawer.draw(path);
}

void add_trails(std::span<const Trail> trails, const Overlay* color, Rect visible, OverlayDrawing& drawing) {
  for (const Trail& trail : trails) {
    for (std::size_t i = 1; i < trail.size(); ++i) {
      if (!meets(trail[i - 1], trail[i], visible)) continue;
      const double age = 1 - static_cast<double>(i) / static_cast<double>(trail.size() - 1);
      drawing.lines.push_back(
          {.overlay = color, .from = trail[i - 1], .to = trail[i], .strength = 1 - age * (1 - kFaintest)});
    }
  }
}

namespace {

void draw_swept_paths(const OverlaySource& source, OverlayPen& pen) {
  add_swept_paths(source, pen.visible(), pen.drawing());
}

void draw_trails(const OverlaySource& source, OverlayPen& pen) {
  if (!source.trails) return;
  for (const ColoredTrails& some : source.trails())
    add_trails(some.trails, some.color, pen.visible(), pen.drawing());
}

}  // namespace

namespace overlay {

const Overlay swept_path{
    .key = "swept_path",
    .label = "swept path",
    .help = "The path of each body in the last step, with its box at every contact.",
    .group = OverlayGroup::path,
    .color = 0x8fd3ff,
    .safe_color = 0x6ee4ff,
    .digit = '3',
    .shift = true,
    .layer = -1,
    .covers_much = true,
    .draw = draw_swept_paths,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({0.5, 0.5, 3, 3});
          pen.box({4.5, 4.5, 3, 3});
          pen.line({2, 2}, {6, 6});
        },
};

const Overlay trails{
    .key = "trails",
    .label = "trails",
    .help =
        "Where the chosen body's centre was in the last frames; without a chosen body, those of the "
        "first four.",
    .group = OverlayGroup::path,
    .color = 0xffb7e0,
    .safe_color = 0xffe48c,
    .digit = '4',
    .shift = true,
    .layer = 1,
    .is_faint = true,
    .covers_much = true,
    .draw = draw_trails,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0, 6}, {3, 2}, false, 0.5);
          pen.line({3, 2}, {8, 5});
        },
};

}  // namespace overlay
}  // namespace talus
