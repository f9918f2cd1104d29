// The tools of the level's canvases, and the hand that holds one of them.
#pragma once

#include <map>
#include <memory>

#include "level_tool.h"

namespace talus {

std::unique_ptr<LevelTool> make_stamp_tool();
std::unique_ptr<LevelTool> make_select_tool();
std::unique_ptr<LevelTool> make_fill_tool();
std::unique_ptr<LevelTool> make_line_tool();
std::unique_ptr<LevelTool> make_rectangle_tool();
std::unique_ptr<LevelTool> make_ellipse_tool();
std::unique_ptr<LevelTool> make_slope_tool();
std::unique_ptr<LevelTool> make_curve_tool();  // also draws segments
std::unique_ptr<LevelTool> make_body_tool();
std::unique_ptr<LevelTool> make_erase_tool();
std::unique_ptr<LevelTool> make_pick_tool();
std::unique_ptr<LevelTool> make_ground_tool();
std::unique_ptr<LevelTool> make_flag_tool();
std::unique_ptr<LevelTool> make_object_tool();

// Uses the chosen tool with the left button. A drag continues with the tool that began it, even if another
// one is chosen. Escape cancels it.
class LevelToolHand {
 public:
  static constexpr int kNoButton = -1, kLeft = 0, kMiddle = 2;

  LevelToolHand();
  // Call it in every frame in which the mouse may act. use: without the fields about the drag. pressed: the
  // button that went down on the canvas in this frame: kLeft, kMiddle (which picks tiles with any tool), or
  // kNoButton.
  void update(LevelToolUse use, Actions& actions, int pressed);
  void draw(ImDrawList& list, LevelToolUse use) const;
  std::string hint(LevelToolUse use) const;  // of the tool; see LevelTool
  bool active() const { return held_ != nullptr; }

 private:
  LevelTool* chosen(const Choices& choices) const;
  const LevelTool* shown(const Choices& choices) const { return active() ? held_ : chosen(choices); }
  void add_drag(LevelToolUse& use) const;

  std::map<MapTool, std::unique_ptr<LevelTool>> tools_;  // none to move the view, which the canvas does
  LevelTool* held_ = nullptr;                            // the tool of the drag; null if there is no drag
  LevelTool* resting_ = nullptr;                         // the one that was chosen; null if there was none
  int button_ = kLeft;
  Cell from_, last_;
  int stroke_ = 0;
};

}  // namespace talus
