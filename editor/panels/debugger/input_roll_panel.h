// The input roll: a strip that shows and changes what is held in each frame.
#pragma once

#include <optional>

#include "panels/panel.h"

namespace talus {

class InputRollPanel final : public Panel {
 public:
  std::string_view id() const override { return panel_id::kInputRoll; }
  std::string_view title() const override { return "Input"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  struct Stroke {  // a drag of the mouse over the frames of one key
    InputKey key;
    bool on;                // what it sets
    std::int64_t from, to;  // frames, in any order
  };
  struct Columns {
    std::int64_t first = 0;  // frame of the leftmost column
    int count = 0;
  };
  Columns visible_frames(const Session& session, float width, float column);
  void draw_ruler(const Session& session, Actions& actions, Ui& ui, Columns view, float column);
  // cell: px of the screen, of a frame in the row.
  void draw_row(int index, const Session& session, Ui& ui, Columns view, ImVec2 cell);
  void draw_mouse_place(const Session& session, Actions& actions, Ui& ui);
  static void take_keys(View& view, int row);
  void handle_row(InputKey key, const Session& session, Columns view, ImVec2 at, float column);

  std::optional<Stroke> stroke_;
  Vec2 typed_;                      // px, in the fields of the mouse's place
  double Vec2::*edited_ = nullptr;  // the one that is being typed into; null: none
  std::int64_t scrolled_ = 0;       // columns by which the wheel moved the strip
  // The frame that was shown then; when another one is shown, the strip follows again.
  std::int64_t scrolled_at_ = -1;
};

}  // namespace talus
