// Camera: which part of the level a canvas shows. The level's origin is on a whole pixel, and so is each zoom
// that the user chooses, so that pixel art stays sharp.
#pragma once

#include <imgui.h>

#include <optional>

#include <talus/collision/geometry.h>
#include <talus/collision/shape.h>

namespace talus {

// A canvas on the screen: from level px to screen px and back.
struct CanvasView {
  ImVec2 min, max;  // px of the screen
  Vec2 origin;      // place of the level's (0,0); at the end of a long level too far away for a float
  float zoom = 1;   // screen px per level px
  TileSize tile{};  // px of the level, of a cell

  ImVec2 to_screen(Vec2 p) const {
    return {static_cast<float>(origin.x + p.x * zoom), static_cast<float>(origin.y + p.y * zoom)};
  }
  Vec2 to_level(ImVec2 p) const { return {(p.x - origin.x) / zoom, (p.y - origin.y) / zoom}; }
  Cell to_cell(ImVec2 p) const;
  // The top-left corner of a cell, px of the screen.
  ImVec2 corner_of(Cell cell) const {
    return to_screen({1.0 * cell.x * tile.width, 1.0 * cell.y * tile.height});
  }
  Rect visible() const;  // level px
};

class Camera {
 public:
  float zoom() const;
  // Whether fit() or show() set it last; follow() does not count.
  bool is_untouched() const { return untouched_ && !kept_; }
  void keep(bool on) { kept_ = on; }  // as if the user had chosen what it shows
  // Zooms by `steps` (> 0: in) and keeps what lies at `at` in place; px from the canvas's corner.
  void zoom_at(ImVec2 at, int steps);
  void scroll(Vec2 pixels);  // px of the screen
  void centre(Vec2 point, ImVec2 canvas);
  // What was in the middle of a canvas stays there when the canvas has another size.
  void keep_middle(ImVec2 before, ImVec2 now);
  // Whether the point is on the canvas, with some room around it, and large enough to be seen, which it is
  // not in the world view.
  bool is_in_sight(Vec2 point, ImVec2 canvas) const;
  // Whether the point is on the canvas at all.
  bool is_on_canvas(Vec2 point, ImVec2 canvas) const { return missing(point, {}, canvas) == Vec2{}; }
  // Scrolls as little as needed to show the point with some room around it; the world view shows it anyway.
  void keep_in_sight(Vec2 point, ImVec2 canvas);
  // Scrolls as little as needed to have the point in the middle third of the canvas, as far as the map goes;
  // the world view stays, and so does a side along which all that show() was given is seen. `map` is the
  // map's size. Returns whether it scrolled.
  bool follow(Vec2 point, Vec2 map, ImVec2 canvas);
  // Whether follow() would not scroll.
  bool is_in_middle(Vec2 point, ImVec2 canvas) const;
  // Sets the largest zoom at which a level of this size, in px, fits, and centres it.
  void fit(Vec2 level, ImVec2 canvas);
  // Shows an area of the map, px of the level, as large as it fits. The zoom is a step if one is close: the
  // lower one, or, if the area may be cut at its edges, the upper one. Shows nothing beside `bounds`, px of
  // the level; if they are smaller than the canvas they lie in its middle.
  void show(const Rect& area, bool may_be_cut, const Rect& bounds, ImVec2 canvas);
  // Shows the map from its top left corner, at the largest step at which its width fits; but not below
  // `least` and else not above `most`, screen px per px of the level. Where the step from `least` on would
  // cut it, but a zoom between two steps does not, it has that. From now on a smaller map lies in the corner.
  void show_corner(float least, float most, Vec2 map, ImVec2 canvas);
  // The world view: shows the whole map, or goes back.
  void toggle_whole(Vec2 map, ImVec2 canvas);
  // True after toggle_whole() until another zoom is chosen.
  bool shows_whole() const { return before_.has_value(); }
  // The same as centre(), but leaves the world view for the zoom before it.
  void leave_whole(Vec2 point, ImVec2 canvas);
  // How far the zoom goes out: until a map of this size fits, but at least to 1/4.
  void limit(Vec2 map, ImVec2 canvas);
  // Keeps a part of the map in sight.
  void clamp(Vec2 map, ImVec2 canvas);
  // Shows nothing beside the map; one that is smaller than the canvas lies in its middle, or in its corner
  // after show_corner().
  void stay_on_map(Vec2 map, ImVec2 canvas);
  // tile: px of the level, of a cell.
  CanvasView view(ImVec2 min, ImVec2 size, TileSize tile) const;

 private:
  void stay_on(const Rect& bounds, ImVec2 canvas);
  struct Place {
    int step;
    std::optional<float> between;
    Vec2 offset;
  };
  // px of the screen to scroll by until the point has so much room around it.
  Vec2 missing(Vec2 point, Vec2 room, ImVec2 canvas) const;
  // The same until it is in the middle third, along the sides that have more to show.
  Vec2 missing_to_middle(Vec2 point, ImVec2 canvas) const;

  int step_ = 16;                 // 2x
  std::optional<float> between_;  // the zoom, if it is one between step_ and the next
  int least_ = 13;                // the lowest step
  Vec2 offset_;                   // px of the screen, from the canvas's corner to the level's
  bool untouched_ = true;
  bool kept_ = false;
  std::optional<Rect> bounds_;   // px of the level, that show() was given
  double share_before_ = 0.5;    // of the room that a smaller map leaves, how much lies left of it and above
  std::optional<Place> before_;  // the view before the world view
};

}  // namespace talus
