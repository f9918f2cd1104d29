// LevelPreview: a level that plays by itself in a small picture.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <talus/sim/solver.h>
#include "level/hard_case.h"
#include "panels/canvas/body_drawing.h"
#include "panels/ui/ui.h"

namespace talus {

// For levels that come with the program: all of the level is kept, and its opening area is shown.
class LevelPreview {
 public:
  // Reads the file. A level that cannot be read is a dark field.
  explicit LevelPreview(const std::string& path);

  // Makes one step. After some seconds, or when the player has left the picture, it starts again.
  void step();
  // Draws the level as it is now into a rectangle of the current window, px of the screen.
  void draw(ImVec2 min, ImVec2 max, Ui& ui) const;
  std::int64_t frame() const { return state_.frame; }  // steps since it started

 private:
  Input input() const;  // of the next step: that of the hard case, or of a hand that runs to and fro
  bool is_over() const;
  const std::shared_ptr<const SheetPicture>& image_of(CellRect tiles) const;
  void draw_body(const BodyDrawing& drawing, const Body& body, const CanvasView& view, Ui& ui) const;

  Level level_;
  HardCase case_;                                // without input if the level is no hard case
  Rect area_;                                    // px of the level, of whole cells
  std::shared_ptr<const SheetPicture> picture_;  // of the area; null: the level could not be read
  // Of tiles that bodies show, by their place and size on the sheet.
  mutable std::map<std::array<int, 4>, std::shared_ptr<const SheetPicture>> images_;
  std::unique_ptr<Solver> solver_;
  State start_, state_;
};

// The previews of a page. Each is read when it is first drawn, at most one in a frame.
class LevelPreviews {
 public:
  static constexpr int kMaxSteps = 2;  // of a preview in a frame: a slow window plays slower

  // Call it in each frame before the previews are drawn. moves: whether they play on.
  void begin_frame(double time, bool moves);
  void draw(const std::string& path, ImVec2 min, ImVec2 max, Ui& ui);
  // Forgets all of them.
  void clear();

 private:
  std::map<std::string, LevelPreview> previews_;  // by path
  double time_ = 0;                               // s, up to which they have played
  int steps_ = 0;                                 // of each preview in this frame
  bool may_read_ = true;                          // none was read in this frame
};

}  // namespace talus
