// KeyCursor: a pointer that the keyboard moves over the canvases, cell by cell. While it is shown it stands
// in for the mouse, buttons and all, so that every tool works with it as it is.
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

// A canvas that the cursor can be on, in units of its own: px of the level, or of the art.
struct CursorGround {
  CellRect room;  // units, at least one wide and high: where it may go
  int cell = 1;   // units, side of what an arrow key goes over; at least 1
  bool on_corners =
      false;  // it goes from corner to corner, the last ones included; else from middle to middle
};

// What the mouse is said to be.
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
  // Shows it on the first of these canvases that is there, or else on the first one as soon as it comes.
  void go_to(std::initializer_list<std::string_view> canvases);
  void go_to_next();  // canvas of those that are there, in the order in which they are drawn
  void hide();        // the buttons are let go first, where it is
  void move(Cell by, Stride stride);
  // Holds a button down until the key goes up that is at work; without one, for a click.
  void press(int button);
  void toggle_pen() { pen_ = !pen_; }

  // --- For the window
  void work_by(int key) { key_ = key; }  // the key whose command runs; kNoKey: none
  void release(int key);
  void lift();  // the pen, and whatever is pressed
  // What the mouse is in the frame that begins; nothing: what it is.
  std::optional<CursorPointer> begin_frame();

  // --- For a canvas, once in each frame in which it is drawn, before its picture: moves the cursor if it is
  // there, and returns where the canvas must show it, in units, if it has moved. mouse: px of the screen.
  std::optional<Vec2> visit(std::string_view canvas, const CanvasView& view, const CursorGround& ground,
                            ImVec2 mouse);
  // With the view that is drawn: shows the cursor if it is there.
  void draw(std::string_view canvas, ImDrawList& list, const CanvasView& view, float scale);

 private:
  struct Button {
    bool wanted = false;
    int key = 0;        // that holds it; 0: a click
    bool ends = false;  // the click is done, and ends where it was
  };
  Vec2 moved(Vec2 place) const;
  Vec2 kept_inside(Vec2 place) const;
  bool wants_down(int button) const {
    return buttons_[static_cast<std::size_t>(button)].wanted || (button == kLeft && pen_);
  }

  bool on_ = false, pen_ = false;
  std::string canvas_;    // that it is on
  bool entered_ = false;  // it has come there, and has no place yet
  bool waits_ = false;    // its canvas may come in this frame
  CursorGround ground_;   // of that canvas
  Cell asked_;            // strides that are still to be gone
  Stride stride_ = Stride::cell;
  std::map<std::string, Vec2, std::less<>> places_;  // units, by canvas: where it is, or was last
  std::vector<std::string> drawn_, there_;           // canvases of this frame so far, and of the last one
  std::optional<ImVec2> screen_;                     // px of the screen, where it is drawn
  std::array<Button, 2> buttons_;
  int key_ = 0;                         // at work
  std::optional<CursorPointer> given_;  // in this frame
};

}  // namespace talus
