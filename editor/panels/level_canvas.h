// LevelCanvas: a view of the level with its bodies, overlays and tools as layers. The map and the play view
// are two of them.
#pragma once

#include "camera.h"
#include "line_gesture.h"
#include "map_gesture.h"
#include "session/session.h"
#include "spawn_gesture.h"
#include "ui.h"

namespace talus {

class LevelCanvas {
 public:
  enum class Kind {
    map,   // shows the level as it is drawn, and paints on it
    play,  // shows the bodies with the overlays; the left button holds balls
  };
  explicit LevelCanvas(Kind kind) : kind_(kind) {}

  void draw(const Session& session, Actions& actions, Ui& ui, ImVec2 size);
  // The other side of a comparison, where this canvas shows the first; with no mouse of its own.
  void draw_other_side(const Session& session, Ui& ui, ImVec2 size) const;

 private:
  bool is_play() const { return kind_ == Kind::play; }
  void start_afresh(const Session& session, const Ui& ui, ImVec2 size);
  void take_requests(const Session& session, Ui& ui, ImVec2 size);
  void handle_mouse(const Session& session, Actions& actions, Ui& ui, const CanvasView& view);
  void zoom_by_wheel(ImVec2 at);
  bool handle_panning(const Session& session, const Ui& ui, bool paints, bool hovered);
  void handle_play_mouse(const Session& session, Actions& actions, const CanvasView& view, bool hovered);
  void draw_layers(const Session& session, const CanvasView& view, const Ui& ui) const;
  void draw_preview(const Session& session, const CanvasView& view, const Ui& ui) const;
  void draw_held(const Session& session, const CanvasView& view, const Ui& ui) const;
  void draw_captions(const Session& session, const CanvasView& view, const Ui& ui) const;

  Kind kind_;
  Camera camera_;
  MapGesture gesture_;
  SpawnGesture spawn_gesture_;
  LineGesture line_gesture_;
  int level_number_ = -1;  // of the level that the camera was set for
  float wheel_ = 0;        // clicks of the wheel that made no whole step yet
  ImVec2 size_;            // px, of the canvas in the last frame
  bool panning_ = false;
  bool holding_ = false;  // the left button went down on the play view
};

}  // namespace talus
