// Places the labels of the overlays: near their bodies, apart from one another, and not over the things that
// they label.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera.h"
#include "overlay/overlay.h"

namespace talus {

// A rectangle on the screen, px.
struct ScreenBox {
  ImVec2 min, max;
  bool meets(const ScreenBox& b) const;
  bool inside(const ScreenBox& b) const;
  ScreenBox grown(float by) const;
  ImVec2 nearest(ImVec2 p) const;            // its point that is nearest to p
  float distance(const ScreenBox& b) const;  // 0 when they touch
  // Whether their distance is at most that; quicker than distance().
  bool is_within(float reach, const ScreenBox& b) const;
};

struct PlacedLabel {
  const OverlayLabel* label;
  ScreenBox box;                // of the plate below the text
  std::optional<ImVec2> point;  // start of a line to the label; nothing in a list beside its body
};

// px at scale 1, from a label to its body: a label without room within it is left out.
inline constexpr float kLabelReach = 40;

// The taken parts of a canvas, in squares of kCell px; with many bodies there are thousands of boxes.
class TakenBoxes {
 public:
  static constexpr float kCell = 2;

  TakenBoxes(const ScreenBox& canvas, std::span<const ScreenBox> boxes);
  void add(const ScreenBox& box);         // takes each square that the box touches
  bool meet(const ScreenBox& box) const;  // whether it touches a taken square

 private:
  // Calls visit(word, bits) for the box's squares, row by row, until it returns true; then so does this.
  template <class Visit>
  bool any_word(const ScreenBox& box, Visit visit) const;

  ImVec2 origin_;
  int columns_, rows_;               // of squares
  std::size_t words_;                // of a row
  std::vector<std::uint64_t> bits_;  // row by row, a bit for each square
};

class LabelPlacer {
 public:
  // taken: what no label may cover. pointed_at: id of the body under the mouse, 0: no body. The labels of
  // this body and of the chosen one come first; important ones without room are listed beside the body.
  LabelPlacer(const CanvasView& view, float scale, int pointed_at, std::span<const ScreenBox> taken)
      : view_(view),
        scale_(scale),
        pointed_at_(pointed_at),
        taken_(
            {{view.min.x - kReserve, view.min.y - kReserve}, {view.max.x + kReserve, view.max.y + kReserve}},
            taken) {}

  // `labels` must outlive the result.
  std::vector<PlacedLabel> place(std::span<const OverlayLabel> labels);
  ImVec2 padding() const { return {3 * scale_, 1 * scale_}; }

 private:
  static constexpr float kReserve =
      64;  // px around the canvas: what lies there keeps labels away inside, too
  int rank_of(const OverlayLabel& label) const;
  bool is_said(const OverlayLabel& label, std::span<const PlacedLabel> placed, const ScreenBox& place) const;
  std::optional<PlacedLabel> find_room(const OverlayLabel& label) const;
  bool is_free(const ScreenBox& box) const;
  void list(std::span<const OverlayLabel* const> labels, std::vector<PlacedLabel>& placed) const;
  ImVec2 size_of(const OverlayLabel& label) const;
  ScreenBox body_of(const OverlayLabel& label) const;

  const CanvasView& view_;
  float scale_;
  int pointed_at_;
  TakenBoxes taken_;
};

}  // namespace talus
