// KeyCursor: a pointer that the keyboard moves over the canvases, cell by cell. While it is shown it replaces
// the mouse and its buttons, so that every tool works with it unchanged.
#pragma once

#include <imgui.h>

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera.h"
#include "level/cell_rect.h"

namespace talus {

// A canvas that the cursor can be on, in units of its own: px of the level or of the art.
struct CursorGround {
  CellRect room;        // units, at least one wide and high: where the cursor may go
  TileSize cell{1, 1};  // units, the step of an arrow key along each axis
  bool on_corners =
      false;  // it goes from corner to corner, the last ones included; else from middle to middle
};

// The mouse that Dear ImGui sees.
struct CursorPointer {
  ImVec2 at;                   // px of the screen
  std::array<bool, 2> down{};  // left, right
};

class KeyCursor {
 public:
  enum class Stride { cell, far, unit };
  static constexpr int kFar = 8;  // cells
  static constexpr int kLeft = 0, kRight = 1;

  bool on() const { return on_; }
  bool is_on(std::string_view canvas) const { return on_ && canvas_ == canvas; }
  // Whether the left button is held down until it is lifted again.
  bool pen_down() const { return pen_; }

  // --- For the commands
  // Shows it on the first of these canvases that is drawn, or else on the first one as soon as that is drawn.
  void go_to(std::initializer_list<std::string_view> canvases);
  void go_to_next();  // among the drawn canvases, in the order of drawing
  void hide();        // releases the buttons first
  void move(Cell by, Stride stride);
  // Holds a button down until the current key goes up; without a key, makes a click.
  void press(int button);
  void toggle_pen() { pen_ = !pen_; }

  // --- For the window
  void work_by(int key) { key_ = key; }  // the key whose command runs; kNoKey: no key
  void release(int key);
  void lift();  // lifts the pen, and releases all buttons
  // The mouse of the beginning frame; nothing: the real one.
  std::optional<CursorPointer> begin_frame();

  // Call it for a canvas once in each frame in which it is drawn, before its picture: moves the cursor if it
  // is there. Returns the place that the canvas must show, in units, if it has moved. mouse: px of the
  // screen.
  std::optional<Vec2> visit(std::string_view canvas, const CanvasView& view, const CursorGround& ground,
                            ImVec2 mouse);
  // Call it with the drawn view: shows the cursor if it is there.
  void draw(std::string_view canvas, ImDrawList& list, const CanvasView& view, float scale);

 private:
  struct Button {
    bool wanted = false;
    int key = 0;        // the key that holds it; 0: a click
    bool ends = false;  // the click is done, and ends where it was
  };
  Vec2 moved(Vec2 place) const;
  Vec2 kept_inside(Vec2 place) const;
  bool wants_down(int button) const {
    return buttons_[static_cast<std::size_t>(button)].wanted || (button == kLeft && pen_);
  }

  bool on_ = false, pen_ = false;
  std::string canvas_;    // the canvas that it is on
  bool entered_ = false;  // it has come to the canvas, and has no place yet
  bool waits_ = false;    // its canvas may be drawn in this frame
  CursorGround ground_;   // of that canvas
  Cell asked_;            // steps that are still to be made
  Stride stride_ = Stride::cell;
  std::map<std::string, Vec2, std::less<>> places_;  // units, by canvas: its last place
  std::vector<std::string> drawn_, there_;  // canvases drawn so far in this frame, and those of the last one
  std::optional<ImVec2> screen_;            // px of the screen, its drawn place
  std::array<Button, 2> buttons_;
  int key_ = 0;                         // the current key
  std::optional<CursorPointer> given_;  // the mouse of this frame
};

}  // namespace talus
