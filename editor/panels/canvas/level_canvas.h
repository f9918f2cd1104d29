// LevelCanvas: a view of the level with its bodies, overlays and tools as layers. The map and the play view
// are two of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "camera.h"
#include "camera_hand.h"
#include "level_at_frame.h"
#include "minimap.h"
#include "overlay_legend.h"
#include "panels/tools/level/level_tools.h"
#include "panels/ui/ui.h"
#include "session/session.h"
#include "sheet_overlay.h"

namespace talus {

class LevelCanvas {
 public:
  enum class Kind {
    map,   // shows the level as it is drawn, and paints on it
    play,  // shows the bodies with the overlays; the left button holds balls
  };
  // name: prefix of its widgets: "map", "play". is_second: the second one of two maps.
  LevelCanvas(Kind kind, std::string name, bool is_second = false)
      : kind_(kind), is_second_(is_second), name_(std::move(name)) {}

  void draw(const Session& session, Actions& actions, Ui& ui, ImVec2 size);
  // Draws the other side of a comparison if this canvas shows the first; it has no mouse of its own.
  void draw_other_side(const Session& session, Ui& ui, ImVec2 size);

 private:
  // Whether a drag that changes the level is going on: it continues even if another tool is chosen.
  bool is_editing() const { return hand_.active(); }
  LevelToolUse use(const Session& session, const CanvasView& view, Ui& ui) const;
  bool is_play() const { return kind_ == Kind::play; }
  // Whether the chosen tool works here, and not the hand that holds bodies.
  bool paints(const View& view) const { return !is_play() || view.canvas.paint_in_play; }
  void start_afresh(const Session& session, const Ui& ui, ImVec2 size);
  void show_opening(const Session& session, const Ui& ui, ImVec2 size);
  void take_requests(const Session& session, Ui& ui, ImVec2 size);
  void handle_mouse(const Session& session, Actions& actions, Ui& ui, const CanvasView& view);
  void follow_cursor(const Session& session, Ui& ui, const CanvasView& view);
  // The part of the level that a canvas at `min` shows, px of the screen.
  CanvasView view_at(ImVec2 min, ImVec2 size, const Session& session) const {
    return camera_.view(min, size, session.level().map.tile_size());
  }
  bool handle_world_view(const Session& session, Ui& ui, bool hovered);
  bool handle_minimap(const Session& session, const CanvasView& view, const Ui& ui, bool hovered);
  bool has_minimap(const Ui& ui) const {
    return !is_play() && ui.view.canvas.minimap && !camera_.shows_whole();
  }
  bool has_requests(const View& view) const;
  bool handle_panning(const Session& session, Ui& ui, bool paints, bool hovered);
  void handle_play_mouse(const Session& session, Actions& actions, const CanvasView& view, bool hovered);
  Vec2 pulled_to(const Session& session, Vec2 mouse) const;
  void draw_layers(const Session& session, const CanvasView& view, const Ui& ui);
  void draw_ground(const Session& session, const LevelAtFrame* then, int place, const CanvasView& view,
                   const Ui& ui) const;
  void draw_note_on_body(const Session& session, const CanvasView& view, Ui& ui) const;
  void draw_pull(const Session& session, const CanvasView& view, const Ui& ui) const;
  struct Caption {
    std::string text;
    std::uint32_t color;
  };
  std::vector<Caption> captions(const Session& session, const CanvasView& view, const Ui& ui) const;
  ScreenBox captions_box(const Session& session, const CanvasView& view, const Ui& ui) const;
  OverlayLegend legend(const Session& session, const CanvasView& view, const Ui& ui) const;
  bool pick_cell(const Session& session, Ui& ui, Cell cell, bool hovered) const;
  void note_directions(const Session& session);
  void note_followed(const Session& session, const CanvasView& view, Ui& ui) const;
  void follow_body(const Session& session, const Ui& ui);
  void let_go(Ui& ui) const;
  void draw_captions(const Session& session, const CanvasView& view, Ui& ui) const;
  // Of a level without bodies: what to do, and a button.
  void offer_player(const Session& session, const CanvasView& view, Actions& actions, Ui& ui);
  bool has_ground_tiles(const Session& session);

  Kind kind_;
  bool is_second_;
  std::string name_;
  Camera camera_;
  CameraHand camera_hand_;
  LevelToolHand hand_;
  SheetOverlay sheet_overlay_;
  Minimap minimap_;
  // In the play view: the level as it was at the shown frame, on this side and on the other one.
  LevelAtFrame level_at_frame_, other_level_at_frame_;
  int level_number_ = -1;   // number of the level that the camera was set for
  bool compiling_ = false;  // whether its bodies were not all there then
  // Frame and body to which the view has gone; nothing if it follows none.
  std::optional<std::pair<std::int64_t, int>> followed_;
  int followed_body_ = 0;        // id of the body that the view went with last; 0: there was none
  bool waits_for_body_ = false;  // a body that was chosen in sight: until it comes to the middle or leaves
  std::optional<std::uint64_t> looked_for_ground_at_;  // the level's revision
  bool has_ground_tiles_ = false;                      // at that revision
  std::unordered_map<int, bool> looks_left_;  // by id of bodies with pictures, which way they went last
  ImVec2 size_;                               // px, of the canvas in the last frame
  bool holding_ = false;                      // whether the left button went down on the play view
  std::optional<Vec2> grip_;  // px from the corner of the body that was pressed then; nothing: none was
};

}  // namespace talus
