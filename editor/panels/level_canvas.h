// LevelCanvas: a view of the level with its bodies, overlays and tools as layers. The map and the play view
// are two of them.
#pragma once

#include <string>
#include <utility>

#include "camera.h"
#include "curve_gesture.h"
#include "flag_brush.h"
#include "ground_gesture.h"
#include "level_then.h"
#include "line_gesture.h"
#include "map_gesture.h"
#include "minimap.h"
#include "overlay_legend.h"
#include "select_gesture.h"
#include "session/session.h"
#include "sheet_overlay.h"
#include "spawn_gesture.h"
#include "ui.h"

namespace talus {

class LevelCanvas {
 public:
  enum class Kind {
    map,   // shows the level as it is drawn, and paints on it
    play,  // shows the bodies with the overlays; the left button holds balls
  };
  // name: of its widgets: "map", "play". is_second: of two maps.
  LevelCanvas(Kind kind, std::string name, bool is_second = false)
      : kind_(kind), is_second_(is_second), name_(std::move(name)) {}

  void draw(const Session& session, Actions& actions, Ui& ui, ImVec2 size);
  // The other side of a comparison, where this canvas shows the first; with no mouse of its own.
  void draw_other_side(const Session& session, Ui& ui, ImVec2 size);

 private:
  // Whether a drag that changes the level is under way: it goes on, whatever tool is chosen meanwhile.
  bool is_editing() const {
    return gesture_.active() || select_gesture_.active() || spawn_gesture_.active() ||
           line_gesture_.active() || curve_gesture_.active() || flag_brush_.active() ||
           ground_gesture_.active();
  }
  void edit(const Session& session, Actions& actions, Ui& ui, const CanvasView& view, bool pressed);
  bool is_play() const { return kind_ == Kind::play; }
  void start_afresh(const Session& session, const Ui& ui, ImVec2 size);
  void take_requests(const Session& session, Ui& ui, ImVec2 size);
  void handle_mouse(const Session& session, Actions& actions, Ui& ui, const CanvasView& view);
  void follow_cursor(const Session& session, Ui& ui, const CanvasView& view);
  bool handle_world_view(const Session& session, bool hovered);
  bool handle_minimap(const Session& session, const CanvasView& view, const Ui& ui, bool hovered);
  bool has_minimap(const Ui& ui) const { return !is_play() && ui.view.minimap && !camera_.shows_whole(); }
  bool has_requests(const View& view) const;
  void zoom_by_wheel(ImVec2 at);
  bool handle_panning(const Session& session, const Ui& ui, bool paints, bool hovered);
  void handle_play_mouse(const Session& session, Actions& actions, const CanvasView& view, bool hovered);
  void draw_layers(const Session& session, const CanvasView& view, const Ui& ui);
  void draw_ground(const Session& session, const LevelThen* then, int place, const CanvasView& view,
                   const Ui& ui) const;
  void draw_preview(const Session& session, const CanvasView& view, Ui& ui) const;
  void draw_held(const Session& session, const CanvasView& view, const Ui& ui) const;
  struct Caption {
    std::string text;
    std::uint32_t color;
  };
  std::vector<Caption> captions(const Session& session, const CanvasView& view, const Ui& ui) const;
  ScreenBox captions_box(const Session& session, const CanvasView& view, const Ui& ui) const;
  OverlayLegend legend(const Session& session, const CanvasView& view, const Ui& ui) const;
  bool pick_cell(const Session& session, Ui& ui, Cell cell, bool hovered) const;
  void follow_body(const Session& session, const Ui& ui);
  void draw_captions(const Session& session, const CanvasView& view, const Ui& ui) const;

  Kind kind_;
  bool is_second_;
  std::string name_;
  Camera camera_;
  MapGesture gesture_;
  SelectGesture select_gesture_;
  SheetOverlay sheet_overlay_;
  GroundGesture ground_gesture_;
  Minimap minimap_;
  FlagBrush flag_brush_;
  SpawnGesture spawn_gesture_;
  LineGesture line_gesture_;
  CurveGesture curve_gesture_;
  LevelThen then_, other_then_;  // of play, at the shown frame: the level of this side and of the other one
  int level_number_ = -1;        // of the level that the camera was set for
  float wheel_ = 0;              // clicks of the wheel that made no whole step yet
  ImVec2 size_;                  // px, of the canvas in the last frame
  bool panning_ = false;
  bool holding_ = false;  // the left button went down on the play view
};

}  // namespace talus
