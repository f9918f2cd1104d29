// The dialog that makes the map larger or smaller, or shifts everything on it.
#pragma once

#include <optional>

#include "level/resize.h"
#include "panels/panel.h"

namespace talus {

class ResizePanel : public Panel {
 public:
  std::string_view id() const override { return "resize"; }
  std::string_view title() const override { return "Size of the map"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_fields(const TileMap& map, Ui& ui);
  void draw_sizes(const TileMap& map, Ui& ui);
  void draw_anchors(const TileMap& map, Ui& ui);
  void draw_shift(Ui& ui);
  void draw_preview(const TileMap& map, const Ui& ui) const;
  void draw_answers(const Session& session, Actions& actions, Ui& ui);
  bool draw_apply(bool enabled, Ui& ui) const;
  bool draw_cancel(Ui& ui);
  void choose_anchor(const TileMap& map);
  const ResizedMap& result(const Session& session);
  void close(Ui& ui);

  bool was_open_ = false;
  bool asks_ = false;          // whether it asks if things may be lost
  bool began_to_ask_ = false;  // the button that goes back gets the focus
  MapFrame typed_;             // what the fields say, possible or not
  MapFrame frame_;             // the last possible one
  Cell anchor_{0, 0};          // 0, 1 or 2: place of the old map: left or top, middle, right or bottom
  // The result of the frame, and the frame and revision of the level that it belongs to.
  std::optional<ResizedMap> result_;
  MapFrame result_frame_;
  std::uint64_t result_revision_ = 0;
};

}  // namespace talus
