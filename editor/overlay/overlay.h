// Turns a step's records into lines, boxes, marks and labels in level pixels. The canvas only strokes them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/sim/record.h>
#include <talus/sim/state.h>
#include "overlay_id.h"

namespace talus {

inline constexpr double kPixelsPerVelocity = 4;  // px of a velocity's arrow for each px/frame

struct OverlayLine {
  OverlayId overlay;
  Vec2 from, to;
  bool arrow = false;   // a head at `to`
  double strength = 1;  // 0 to 1: fainter
  bool detail = false;  // left out at low zoom
};
struct OverlayBox {
  OverlayId overlay;
  Rect box;
  bool filled = false;  // lightly tinted; else an outline
};
struct OverlayMark {  // a small cross
  OverlayId overlay;
  Vec2 at;
};
struct OverlayBar {  // a gauge from 0 to 1 above a box
  OverlayId overlay;
  Rect box;         // of the bar
  double fraction;  // filled part
};
struct OverlayLabel {
  OverlayId overlay;
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

// What is drawn: a frame of a run.
struct OverlaySource {
  const Scene& scene;
  const State& state;
  const StepRecord& record;         // of the step that led there
  const Terrain* ground = nullptr;  // of the level, whatever the solver; null: not known
  int chosen_body = 0;              // id, whose details are always labelled; 0: none
};

// `visible`: level px; what lies wholly outside is left out.
OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible);

}  // namespace talus
