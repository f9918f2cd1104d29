// The icons: a few strokes each, in a unit square.
#include "icons.h"

#include <algorithm>
#include <initializer_list>

namespace talus {
namespace {

class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 at, float size, ImU32 color)
      : list_(list), at_(at), size_(size), color_(color), width_(std::max(1.0f, size / 11)) {}

  ImVec2 point(ImVec2 p) const { return {at_.x + p.x * size_, at_.y + p.y * size_}; }
  void stroke(std::initializer_list<ImVec2> points, bool closed = false) const {
    for (ImVec2 p : points) list_.PathLineTo(point(p));
    list_.PathStroke(color_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
  }
  void solid(std::initializer_list<ImVec2> points) const {
    for (ImVec2 p : points) list_.PathLineTo(point(p));
    list_.PathFillConvex(color_);
  }
  void box(float x0, float y0, float x1, float y1) const {
    list_.AddRectFilled(point({x0, y0}), point({x1, y1}), color_);
  }
  void frame(float x0, float y0, float x1, float y1) const {
    stroke({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true);
  }
  void arc(ImVec2 centre, float radius, float from, float to) const {
    list_.PathArcTo(point(centre), radius * size_, from, to, 16);
    list_.PathStroke(color_, ImDrawFlags_None, width_);
  }

 private:
  ImDrawList& list_;
  ImVec2 at_;
  float size_;
  ImU32 color_;
  float width_;
};

void draw_play_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::first_frame:
      pen.box(.15f, .2f, .27f, .8f);
      pen.solid({{.6f, .25f}, {.6f, .75f}, {.28f, .5f}});
      pen.solid({{.92f, .25f}, {.92f, .75f}, {.6f, .5f}});
      break;
    case Icon::last_frame:
      pen.box(.73f, .2f, .85f, .8f);
      pen.solid({{.4f, .25f}, {.72f, .5f}, {.4f, .75f}});
      pen.solid({{.08f, .25f}, {.4f, .5f}, {.08f, .75f}});
      break;
    case Icon::restart:
      pen.arc({.5f, .54f}, .32f, -.4f, 4.4f);
      pen.solid({{.3f, .04f}, {.62f, .2f}, {.34f, .42f}});
      break;
    case Icon::play:
      pen.solid({{.25f, .15f}, {.85f, .5f}, {.25f, .85f}});
      break;
    case Icon::pause:
      pen.box(.22f, .18f, .42f, .82f);
      pen.box(.58f, .18f, .78f, .82f);
      break;
    case Icon::step:
      pen.solid({{.15f, .2f}, {.65f, .5f}, {.15f, .8f}});
      pen.box(.72f, .2f, .84f, .8f);
      break;
    case Icon::step_back:
      pen.solid({{.85f, .2f}, {.85f, .8f}, {.35f, .5f}});
      pen.box(.16f, .2f, .28f, .8f);
      break;
    case Icon::run_on:
      pen.solid({{.08f, .25f}, {.4f, .5f}, {.08f, .75f}});
      pen.solid({{.4f, .25f}, {.72f, .5f}, {.4f, .75f}});
      pen.solid({{.88f, .3f}, {.98f, .5f}, {.88f, .7f}, {.78f, .5f}});
      break;
    case Icon::run_back:
      pen.solid({{.92f, .25f}, {.92f, .75f}, {.6f, .5f}});
      pen.solid({{.6f, .25f}, {.6f, .75f}, {.28f, .5f}});
      pen.solid({{.12f, .3f}, {.22f, .5f}, {.12f, .7f}, {.02f, .5f}});
      break;
    default:  // split
      pen.frame(.1f, .2f, .46f, .8f);
      pen.frame(.54f, .2f, .9f, .8f);
      break;
  }
}

void draw_map_tool_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::stamp:
      pen.box(.15f, .15f, .47f, .47f);
      pen.box(.53f, .53f, .85f, .85f);
      pen.frame(.56f, .15f, .85f, .44f);
      pen.frame(.15f, .56f, .44f, .85f);
      break;
    case Icon::pan:
      pen.stroke({{.5f, .1f}, {.5f, .9f}});
      pen.stroke({{.1f, .5f}, {.9f, .5f}});
      pen.stroke({{.38f, .22f}, {.5f, .1f}, {.62f, .22f}});
      pen.stroke({{.38f, .78f}, {.5f, .9f}, {.62f, .78f}});
      pen.stroke({{.22f, .38f}, {.1f, .5f}, {.22f, .62f}});
      pen.stroke({{.78f, .38f}, {.9f, .5f}, {.78f, .62f}});
      break;
    case Icon::rectangle:
      pen.frame(.14f, .22f, .86f, .78f);
      pen.box(.26f, .34f, .74f, .66f);
      break;
    case Icon::fill:
      pen.stroke({{.42f, .15f}, {.8f, .5f}, {.45f, .85f}, {.1f, .5f}}, true);
      pen.solid({{.14f, .5f}, {.76f, .5f}, {.45f, .82f}});
      pen.solid({{.88f, .6f}, {.96f, .82f}, {.8f, .82f}});
      break;
    case Icon::erase:
      pen.stroke({{.5f, .2f}, {.85f, .5f}, {.55f, .8f}, {.35f, .8f}, {.12f, .58f}}, true);
      pen.solid({{.31f, .39f}, {.66f, .69f}, {.55f, .8f}, {.35f, .8f}, {.12f, .58f}});
      break;
    case Icon::body:
      pen.box(.28f, .12f, .72f, .66f);
      pen.stroke({{.14f, .82f}, {.86f, .82f}});
      break;
    case Icon::slope:
      pen.solid({{.1f, .84f}, {.9f, .3f}, {.9f, .84f}});
      break;
    case Icon::segment:
      pen.stroke({{.16f, .78f}, {.84f, .24f}});
      pen.box(.08f, .7f, .24f, .86f);
      pen.box(.76f, .16f, .92f, .32f);
      break;
    case Icon::curve:
      pen.arc({.5f, .72f}, .36f, 3.1416f, 6.2832f);
      pen.box(.06f, .66f, .22f, .82f);
      pen.box(.78f, .66f, .94f, .82f);
      break;
    case Icon::ground:
      pen.solid({{.08f, .86f}, {.08f, .66f}, {.5f, .66f}, {.5f, .86f}});
      pen.solid({{.44f, .86f}, {.44f, .66f}, {.66f, .36f}, {.92f, .36f}, {.92f, .86f}});
      break;
    default:  // pick
      pen.stroke({{.15f, .85f}, {.2f, .66f}, {.6f, .26f}, {.74f, .4f}, {.34f, .8f}}, true);
      pen.stroke({{.52f, .2f}, {.8f, .48f}});
      pen.solid({{.62f, .28f}, {.76f, .12f}, {.88f, .24f}, {.72f, .38f}});
      break;
  }
}

void draw_sprite_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::pencil:
      pen.stroke({{.14f, .86f}, {.2f, .64f}, {.7f, .14f}, {.86f, .3f}, {.36f, .8f}}, true);
      pen.solid({{.14f, .86f}, {.18f, .7f}, {.3f, .82f}});
      break;
    case Icon::select:
      for (float f : {.12f, .44f, .76f}) {
        for (float side : {.14f, .86f}) {
          pen.stroke({{f, side}, {f + .14f, side}});
          pen.stroke({{side, f}, {side, f + .14f}});
        }
      }
      break;
    case Icon::line:
      pen.stroke({{.14f, .86f}, {.86f, .14f}});
      break;
    case Icon::frame:
      pen.frame(.14f, .22f, .86f, .78f);
      break;
    case Icon::ellipse:
      pen.arc({.5f, .5f}, .37f, 0, 6.2832f);
      break;
    case Icon::neighbours:
      pen.box(.36f, .36f, .64f, .64f);
      for (float f : {.28f, .72f}) {
        pen.stroke({{f, .06f}, {f, .94f}});
        pen.stroke({{.06f, f}, {.94f, f}});
      }
      break;
    case Icon::enlarge:
      pen.stroke({{.55f, .12f}, {.88f, .12f}, {.88f, .45f}});
      pen.stroke({{.12f, .55f}, {.12f, .88f}, {.45f, .88f}});
      pen.stroke({{.88f, .12f}, {.58f, .42f}});
      pen.stroke({{.12f, .88f}, {.42f, .58f}});
      break;
    case Icon::flip_horizontal:
      pen.solid({{.42f, .2f}, {.42f, .8f}, {.1f, .8f}});
      pen.stroke({{.58f, .2f}, {.58f, .8f}, {.9f, .8f}}, true);
      break;
    case Icon::flip_vertical:
      pen.solid({{.2f, .42f}, {.8f, .42f}, {.8f, .1f}});
      pen.stroke({{.2f, .58f}, {.8f, .58f}, {.8f, .9f}}, true);
      break;
    case Icon::rotate:
      pen.arc({.5f, .54f}, .32f, -0.4f, 4.4f);
      pen.solid({{.62f, .34f}, {.94f, .22f}, {.9f, .52f}});
      break;
    default:  // clear
      pen.frame(.18f, .18f, .82f, .82f);
      pen.stroke({{.18f, .82f}, {.82f, .18f}});
      break;
  }
}

void draw_view_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::grid:
      for (float f : {.18f, .5f, .82f}) {
        pen.stroke({{f, .12f}, {f, .88f}});
        pen.stroke({{.12f, f}, {.88f, f}});
      }
      break;
    case Icon::borders:
      pen.frame(.12f, .22f, .88f, .78f);
      pen.stroke({{.5f, .22f}, {.5f, .78f}});
      break;
    case Icon::minimap:
      pen.frame(.1f, .16f, .9f, .84f);
      pen.box(.52f, .5f, .78f, .74f);
      break;
    case Icon::dice:
      pen.frame(.14f, .14f, .86f, .86f);
      for (float f : {.26f, .44f, .62f}) pen.box(f, f, f + .12f, f + .12f);
      break;
    case Icon::zoom_in:
      pen.stroke({{.5f, .2f}, {.5f, .8f}});
      [[fallthrough]];
    case Icon::zoom_out:
      pen.stroke({{.2f, .5f}, {.8f, .5f}});
      break;
    default:  // close
      pen.stroke({{.25f, .25f}, {.75f, .75f}});
      pen.stroke({{.25f, .75f}, {.75f, .25f}});
      break;
  }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color) {
  const Pen pen(list, at, size, color);
  if (icon == Icon::none) return;
  if (icon <= Icon::split) return draw_play_icon(pen, icon);
  if (icon <= Icon::curve) return draw_map_tool_icon(pen, icon);
  if (icon <= Icon::clear) return draw_sprite_icon(pen, icon);
  draw_view_icon(pen, icon);
}

}  // namespace talus
