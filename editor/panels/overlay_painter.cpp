// Strokes lines, boxes, marks, bars and labels in level pixels onto a canvas.
#include "overlay_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "theme.h"

namespace talus {
namespace {

constexpr float kLowZoom = 2;      // at scale 1; below, labels that are not important are left out
constexpr float kNormalsZoom = 4;  // at scale 1; below, normals are shorter, so that they do not hide balls
constexpr float kReach = 40;       // px at scale 1, of labels from their body
constexpr float kPull = 12;        // px at scale 1: a label's point further from its body is drawn to it
constexpr float kApart = 3;        // px at scale 1, between labels and what they keep clear of
constexpr int kRanks = 4, kMostPieces = 64;
constexpr float kPiece = 16;  // px at scale 1: lines are kept clear in pieces of this length

ImU32 color_of(OverlayId id, int alpha = 255) {
  return theme::color(overlay_infos()[static_cast<std::size_t>(id)].color, alpha);
}

struct Box {
  ImVec2 min, max;
  bool meets(const Box& b) const {
    return min.x < b.max.x && b.min.x < max.x && min.y < b.max.y && b.min.y < max.y;
  }
  bool inside(const Box& b) const {
    return min.x >= b.min.x && min.y >= b.min.y && max.x <= b.max.x && max.y <= b.max.y;
  }
  Box grown(float by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
  ImVec2 nearest(ImVec2 p) const { return {std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y)}; }
  float distance(const Box& b) const {
    return std::hypot(std::max({min.x - b.max.x, b.min.x - max.x, 0.0f}),
                      std::max({min.y - b.max.y, b.min.y - max.y, 0.0f}));
  }
};

class Painter {
 public:
  Painter(ImDrawList& list, const CanvasView& view, float scale, int pointed_at)
      : list_(list),
        view_(view),
        scale_(scale),
        pointed_at_(pointed_at),
        width_(std::max(1.0f, std::round(scale * 1.5f))) {}

  void paint(const OverlayDrawing& drawing, std::span<const Rect> keep_clear) {
    for (const OverlayBox& box : drawing.boxes) paint_box(box);
    for (const OverlayLine& line : drawing.lines) stroke(line, outline(), width_ + 2 * rim());
    for (const OverlayLine& line : drawing.lines) stroke(line, color_of(line.overlay), width_);
    for (const OverlayBar& bar : drawing.bars) paint_bar(bar);
    for (const OverlayMark& mark : drawing.marks) paint_mark(mark);
    for (const Rect& rect : keep_clear) taken_.push_back(screen_box(rect));
    keep_clear_of(drawing);
    paint_labels(drawing.labels);
  }

 private:
  static ImU32 outline() { return theme::color(theme::kDark, 190); }
  float rim() const { return std::max(1.0f, std::round(scale_ * 0.75f)); }

  void paint_box(const OverlayBox& box) {
    const ImVec2 from = view_.to_screen({box.box.x, box.box.y});
    const ImVec2 to = view_.to_screen({box.box.right(), box.box.bottom()});
    if (box.filled) {
      list_.AddRectFilled(from, to, color_of(box.overlay, 70));
      list_.AddRect(from, to, color_of(box.overlay, 150));
      return;
    }
    list_.AddRect(from, to, outline(), 0, 0, width_ + 2 * rim());
    list_.AddRect(from, to, color_of(box.overlay), 0, 0, width_);
  }

  void stroke(const OverlayLine& line, ImU32 color, float width) {
    const auto [from, to] = ends(line);
    list_.AddLine(from, to, color, width);
    if (!line.arrow) return;
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length < 1) return;
    const float head = std::min(6 * scale_, length * 0.7f);
    const float ux = dx / length * head, uy = dy / length * head;
    list_.AddLine(to, {to.x - ux + uy * 0.6f, to.y - uy - ux * 0.6f}, color, width);
    list_.AddLine(to, {to.x - ux - uy * 0.6f, to.y - uy + ux * 0.6f}, color, width);
  }

  void paint_mark(const OverlayMark& mark) {
    const ImVec2 at = view_.to_screen(mark.at);
    const float arm = 4 * scale_;
    for (const auto& [color, width] :
         {std::pair{outline(), width_ + 2 * rim()}, std::pair{color_of(mark.overlay), width_}}) {
      list_.AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, color, width);
      list_.AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, color, width);
    }
  }

  void paint_bar(const OverlayBar& bar) {
    const ImVec2 from = view_.to_screen({bar.box.x, bar.box.y});
    const ImVec2 to = view_.to_screen({bar.box.right(), bar.box.bottom()});
    const float fraction = static_cast<float>(std::clamp(bar.fraction, 0.0, 1.0));
    list_.AddRectFilled({from.x - rim(), from.y - rim()}, {to.x + rim(), to.y + rim()}, outline());
    list_.AddRectFilled(from, to, color_of(bar.overlay, 70));
    list_.AddRectFilled(from, {from.x + (to.x - from.x) * fraction, to.y}, color_of(bar.overlay));
  }

  // What a label is about must stay visible.
  void keep_clear_of(const OverlayDrawing& drawing) {
    for (const OverlayBar& bar : drawing.bars) taken_.push_back(screen_box(bar.box));
    for (const OverlayLine& line : drawing.lines) keep_clear_of(line);
    for (const OverlayMark& mark : drawing.marks) {
      const ImVec2 at = view_.to_screen(mark.at);
      const float arm = 4 * scale_;
      taken_.push_back({{at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}});
    }
  }
  Box screen_box(Rect rect) const {
    return {view_.to_screen({rect.x, rect.y}), view_.to_screen({rect.right(), rect.bottom()})};
  }

  void keep_clear_of(const OverlayLine& line) {
    const auto [from, to] = ends(line);
    const float dx = to.x - from.x, dy = to.y - from.y;
    const int pieces =
        std::clamp(static_cast<int>(std::ceil(std::hypot(dx, dy) / (kPiece * scale_))), 1, kMostPieces);
    const auto at = [&](int i) {
      const float part = static_cast<float>(i) / static_cast<float>(pieces);
      return ImVec2{from.x + dx * part, from.y + dy * part};
    };
    for (int i = 0; i < pieces; ++i) {
      const ImVec2 a = at(i), b = at(i + 1);
      const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
      taken_.push_back(box.grown(width_));
    }
  }

  // Where a line is on the screen.
  std::pair<ImVec2, ImVec2> ends(const OverlayLine& line) const {
    const ImVec2 from = view_.to_screen(line.from), to = view_.to_screen(line.to);
    if (line.overlay != OverlayId::normals) return {from, to};
    const float part = std::min(1.0f, view_.zoom / (kNormalsZoom * scale_));
    return {from, {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part}};
  }

  void paint_labels(const std::vector<OverlayLabel>& labels) {
    std::vector<const OverlayLabel*> without_room;
    const auto paint = [&](const OverlayLabel& label) {
      if (!paint_label(label) && label.body == pointed_at_) without_room.push_back(&label);
    };
    for (int rank = 0; rank < kRanks; ++rank)
      for (const OverlayLabel& label : labels)
        if (rank_of(label) == rank) paint(label);
    if (!without_room.empty()) list_labels(without_room);
  }

  // Which labels come first, and so find room: those of the chosen body and the one under the mouse, then the
  // rarer ones. kRanks: left out.
  int rank_of(const OverlayLabel& label) const {
    if (label.important || (label.body != 0 && label.body == pointed_at_)) return 0;
    if (view_.zoom < kLowZoom * scale_) return kRanks;
    if (label.overlay == OverlayId::slope_delta) return 1;
    if (label.overlay == OverlayId::floor_height) return 2;
    const Rect& b = label.body_box;
    const bool too_slow = label.overlay == OverlayId::velocity && label.at.x >= b.x &&
                          label.at.x <= b.right() && label.at.y >= b.y && label.at.y <= b.bottom();
    return too_slow ? kRanks : 3;  // an arrow that does not leave its body says enough
  }

  // Tries places around the point, near ones first. False when there is no room near the body: then the label
  // is left out.
  bool paint_label(const OverlayLabel& label) {
    const ImVec2 size = size_of(label);
    const Box canvas{view_.min, view_.max}, body = screen_box(label.body_box);
    const ImVec2 at = body.grown(kPull * scale_).nearest(view_.to_screen(label.at));
    for (float gap = 6 * scale_; gap < kReach * scale_; gap += 8 * scale_) {
      const float left = at.x - gap - size.x, right = at.x + gap, middle_x = at.x - size.x / 2;
      const float above = at.y - gap - size.y, below = at.y + gap, middle_y = at.y - size.y / 2;
      std::array<ImVec2, 8> corners = {{{right, above},
                                        {left, above},
                                        {right, below},
                                        {left, below},
                                        {middle_x, above},
                                        {middle_x, below},
                                        {right, middle_y},
                                        {left, middle_y}}};
      if (label.overlay == OverlayId::slope_delta) std::swap(corners[0], corners[4]);  // above its bar
      for (ImVec2 corner : corners) {
        const Box box{corner, {corner.x + size.x, corner.y + size.y}};
        if (!is_free(box) || !box.inside(canvas) || box.distance(body) > kReach * scale_) continue;
        const ImVec2 end = box.nearest(at);
        list_.AddLine(at, end, color_of(label.overlay, 120), std::max(1.0f, std::round(scale_)));
        write(label, box);
        return true;
      }
    }
    return false;
  }

  bool is_free(const Box& box) const {
    const Box wanted = box.grown(kApart * scale_);
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return wanted.meets(other); });
  }

  ImVec2 padding() const { return {3 * scale_, 1 * scale_}; }
  ImVec2 size_of(const OverlayLabel& label) const {
    const ImVec2 text = ImGui::CalcTextSize(label.text.c_str());
    return {text.x + 2 * padding().x, text.y + 2 * padding().y};
  }

  void write(const OverlayLabel& label, const Box& box) {
    list_.AddRectFilled(box.min, box.max, theme::color(theme::kDark, 215), 3 * scale_);
    list_.AddText({std::round(box.min.x + padding().x), std::round(box.min.y + padding().y)},
                  color_of(label.overlay), label.text.c_str());
    taken_.push_back(box);
  }

  // Below one another beside the body under the mouse, over whatever else is there.
  void list_labels(const std::vector<const OverlayLabel*>& labels) {
    ImVec2 all{0, 0};
    for (const OverlayLabel* label : labels) {
      const ImVec2 size = size_of(*label);
      all = {std::max(all.x, size.x), all.y + size.y};
    }
    const Box body = screen_box(labels.front()->body_box).grown(kPull * scale_);
    ImVec2 at{body.max.x, body.min.y - all.y};
    if (at.x + all.x > view_.max.x) at.x = body.min.x - all.x;
    if (at.y < view_.min.y) at.y = body.max.y;
    for (const OverlayLabel* label : labels) {
      const float height = size_of(*label).y;
      write(*label, {at, {at.x + all.x, at.y + height}});
      at.y += height;
    }
  }

  ImDrawList& list_;
  const CanvasView& view_;
  float scale_;
  int pointed_at_;
  float width_;
  std::vector<Box> taken_;
};

}  // namespace

void paint_overlays(ImDrawList& list, const OverlayDrawing& drawing, std::span<const Rect> keep_clear,
                    const CanvasView& view, float scale, int pointed_at) {
  list.PushClipRect(view.min, view.max, true);
  Painter(list, view, scale, pointed_at).paint(drawing, keep_clear);
  list.PopClipRect();
}

void paint_overlay_swatch(ImDrawList& list, OverlayId id, ImVec2 at, float size) {
  // The swatch is a canvas of 8 by 8 level pixels that holds one piece of the overlay.
  const CanvasView view{at, {at.x + size, at.y + size}, at, size / 8};
  OverlayDrawing sample;
  switch (id) {
    case OverlayId::boxes:
      sample.boxes.push_back({id, {1, 1, 6, 6}});
      break;
    case OverlayId::normals:
      sample.lines.push_back({id, {4, 7.5}, {4, 0.5}, true});
      break;
    case OverlayId::touch_points:
      sample.marks.push_back({id, {4, 4}});
      break;
    case OverlayId::velocity:
      sample.lines.push_back({id, {0.5, 6}, {7.5, 2}, true});
      break;
    case OverlayId::slope_delta:
      sample.bars.push_back({id, {0.5, 2.5, 7, 3}, 0.5});
      break;
    case OverlayId::floor_height:
      sample.lines.push_back({id, {0, 5}, {8, 5}});
      break;
    case OverlayId::tested_tiles:
      sample.boxes.push_back({id, {0.5, 0.5, 7, 7}, true});
      break;
    case OverlayId::answer:
      sample.boxes.push_back({id, {3, 1, 4, 4}, true});
      sample.lines.push_back({id, {0, 6.5}, {8, 6.5}});
      break;
  }
  Painter(list, view, size / 16, 0).paint(sample, {});
}

}  // namespace talus
