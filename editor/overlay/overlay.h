// Turns a step's records into lines, boxes, marks and labels in level pixels. The canvas only strokes them.
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

inline constexpr double kPixelsPerVelocity = 4;  // px of a velocity's arrow for each px/frame

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
  bool filled = false;  // lightly tinted; else an outline
};
struct OverlayMark {  // a small cross
  const Overlay* overlay;
  Vec2 at;
};
struct OverlayBar {  // a gauge from 0 to 1 above a box
  const Overlay* overlay;
  Rect box;         // of the bar
  double fraction;  // filled part
};
struct OverlayLabel {
  const Overlay* overlay;
  Vec2 at;  // the point that it belongs to; the canvas keeps the text beside, not over it
  std::string text;
  bool important = true;  // false: left out at low zoom
  int body = 0;           // id of the body that it is about
  Rect body_box;          // px; the canvas keeps the text near it
};

struct OverlayDrawing {
  std::vector<OverlayLine> lines;
  std::vector<OverlayBox> boxes;
  std::vector<OverlayMark> marks;
  std::vector<OverlayBar> bars;
  std::vector<OverlayLabel> labels;
  OverlayPalette palette = OverlayPalette::standard;
};

// Where a body's centre was, frame by frame, px.
using Trail = std::vector<Vec2>;
struct ColoredTrails {
  std::vector<Trail> trails = {};
  const Overlay* color;
};

// What is drawn: a frame of a run, and what is known beside it.
struct OverlaySource {
  const Scene& scene;
  const State& state;
  const StepRecord& record;             // of the step that led there
  const Terrain* ground = nullptr;      // of the level, whatever the solver; null: not known
  int chosen_body = 0;                  // id, whose details are always labelled; 0: none
  const Level* level = nullptr;         // as it is edited; null: not known
  const HardCase* hard_case = nullptr;  // of the level, which is not null then; null: it is none
  const ReachSearch* reach = nullptr;   // in the level, which is not null then; null: nothing was looked for
  bool reach_is_stale = false;          // the level is another by now
  // Asked for by what draws them alone; empty: there are none.
  std::function<std::vector<ColoredTrails>()> trails = {};
  std::function<std::vector<Stage>()> stages = {};  // of the chosen body's step
};

// `visible`: level px; what lies wholly outside is left out.
OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible);

}  // namespace talus
