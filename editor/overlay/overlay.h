// Turns the records of a step into lines, boxes, marks and labels in level pixels. The canvas only draws
// them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/sim/record.h>
#include <talus/sim/state.h>
#include "debug/stages.h"
#include "level/hard_case.h"
#include "overlay_table.h"
#include "sim/reach.h"

namespace talus {

struct Proof;

inline constexpr double kPixelsPerVelocity = 4;  // length in px of a velocity's arrow for each px/frame
inline constexpr std::size_t kMaxDrawnLines = 262'144;  // of the ground; as many as tiles may have
inline constexpr std::size_t kMaxDrawnBodies = 2000;    // of a picture
// The work of all queries of the ground for a picture, as CastBudget counts it: about 10 ms.
inline constexpr std::int64_t kMaxOverlayWork = 1 << 19;

struct OverlayLine {
  const Overlay* overlay;
  Vec2 from, to;
  bool arrow = false;   // a head at `to`
  double strength = 1;  // 0 to 1: fainter
  bool detail = false;  // left out at low zoom
};
struct OverlayBox {
  const Overlay* overlay;
  Rect box;
  bool filled = false;  // filled with a light tint; false: an outline
  double strength = 1;  // of a tint, 0 to 3: fainter or stronger
};
struct OverlayMark {  // a small cross
  const Overlay* overlay;
  Vec2 at;
};
struct OverlayBar {  // a gauge from 0 to 1 above a box
  const Overlay* overlay;
  Rect box;         // the box of the bar, px
  double fraction;  // the filled part, 0 to 1
};
struct OverlayLabel {
  const Overlay* overlay;
  Vec2 at;  // the point that it belongs to; the canvas puts the text beside it, not over it
  std::string text;
  bool important = true;  // false: left out at low zoom
  int body = 0;           // id of the body that it belongs to
  Rect body_box;          // px; the canvas keeps the text near this box
};

struct OverlayDrawing {
  std::vector<OverlayLine> lines;
  std::vector<OverlayBox> boxes;
  std::vector<OverlayMark> marks;
  std::vector<OverlayBar> bars;
  std::vector<OverlayLabel> labels;
  OverlayPalette palette = OverlayPalette::standard;
  std::int64_t work_left = kMaxOverlayWork;  // for queries of the ground
  bool is_cut = false;                       // something in view is left out, as there is too much
};

// The body's centre in each frame, px.
using Trail = std::vector<Vec2>;
struct ColoredTrails {
  std::vector<Trail> trails = {};
  const Overlay* color;
};

// What is drawn: a frame of a branch, and what belongs to it.
struct OverlaySource {
  const Scene& scene;
  const State& state;
  const StepRecord& record;             // of the step that led to the frame
  const Terrain* ground = nullptr;      // of the level, whatever the solver; null: not known
  int chosen_body = 0;                  // id of the body whose details always have labels; 0: no body
  const Level* level = nullptr;         // as it is edited; null: not known
  const HardCase* hard_case = nullptr;  // of `level`, which is not null then; null: the level is no hard case
  const ReachSearch* reach = nullptr;   // in `level`, which is not null then; null: no search was made
  bool reach_is_stale = false;          // the level has changed since the search
  const Proof* proof = nullptr;         // of `level`, which is not null then; null: it was not proved
  // Called only by overlays that draw trails; empty: there are no trails.
  std::function<std::vector<ColoredTrails>()> trails = {};
  std::function<std::vector<Stage>()> stages = {};  // of the chosen body's step; empty: there are no stages
};

// Returns the drawing. visible: level px; things that lie wholly outside are left out. Of more than
// kMaxDrawnBodies bodies, the chosen one and the first ones in view are drawn.
OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible);

}  // namespace talus
