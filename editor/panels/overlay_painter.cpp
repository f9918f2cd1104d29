// Strokes lines, boxes, marks, bars and labels in level pixels onto a canvas.
#include "overlay_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "theme.h"

namespace talus {
namespace {

constexpr float kShortLine = 96;  // px at scale 1: the box around a longer line is mostly empty
constexpr float kLowZoom = 3;     // at scale 1; below, labels that are not important are left out

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
};

class Painter {
 public:
  Painter(ImDrawList& list, const CanvasView& view, float scale)
      : list_(list), view_(view), scale_(scale), width_(std::max(1.0f, std::round(scale * 1.5f))) {}

  void paint(const OverlayDrawing& drawing, std::span<const Rect> keep_clear) {
    for (const OverlayBox& box : drawing.boxes) paint_box(box);
    for (const OverlayLine& line : drawing.lines) stroke(line, outline(), width_ + 2 * rim());
    for (const OverlayLine& line : drawing.lines) stroke(line, color_of(line.overlay), width_);
    for (const OverlayBar& bar : drawing.bars) paint_bar(bar);
    for (const OverlayMark& mark : drawing.marks) paint_mark(mark);
    for (const Rect& rect : keep_clear) taken_.push_back(screen_box(rect));
    keep_clear_of(drawing);
    for (const OverlayLabel& label : drawing.labels)
      if (label.important) paint_label(label);
    for (const OverlayLabel& label : drawing.labels)
      if (!label.important && view_.zoom >= kLowZoom * scale_) paint_label(label);
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
    const ImVec2 from = view_.to_screen(line.from), to = view_.to_screen(line.to);
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
    for (const OverlayLine& line : drawing.lines) {
      const ImVec2 a = view_.to_screen(line.from), b = view_.to_screen(line.to);
      const Box box{{std::min(a.x, b.x) - width_, std::min(a.y, b.y) - width_},
                    {std::max(a.x, b.x) + width_, std::max(a.y, b.y) + width_}};
      if (box.max.x - box.min.x < kShortLine * scale_ && box.max.y - box.min.y < kShortLine * scale_)
        taken_.push_back(box);
    }
    for (const OverlayMark& mark : drawing.marks) {
      const ImVec2 at = view_.to_screen(mark.at);
      const float arm = 4 * scale_;
      taken_.push_back({{at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}});
    }
  }
  Box screen_box(Rect rect) const {
    return {view_.to_screen({rect.x, rect.y}), view_.to_screen({rect.right(), rect.bottom()})};
  }

  // Tries places around the point, near ones first; a label that fits nowhere is left out.
  void paint_label(const OverlayLabel& label) {
    const ImVec2 text = ImGui::CalcTextSize(label.text.c_str());
    const ImVec2 pad{3 * scale_, 1 * scale_};
    const ImVec2 size{text.x + 2 * pad.x, text.y + 2 * pad.y};
    const ImVec2 at = view_.to_screen(label.at);
    const Box canvas{view_.min, view_.max};
    if (at.x < canvas.min.x || at.x > canvas.max.x || at.y < canvas.min.y || at.y > canvas.max.y) return;
    for (float ring = 1; ring <= 3; ++ring) {
      const float gap = ring * 8 * scale_;
      const std::array<ImVec2, 6> corners = {{{at.x + gap, at.y - gap - size.y},
                                              {at.x - gap - size.x, at.y - gap - size.y},
                                              {at.x + gap, at.y + gap},
                                              {at.x - gap - size.x, at.y + gap},
                                              {at.x - size.x / 2, at.y - gap - size.y},
                                              {at.x - size.x / 2, at.y + gap}}};
      for (ImVec2 corner : corners) {
        const Box box{corner, {corner.x + size.x, corner.y + size.y}};
        const bool free =
            std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.meets(other); });
        if (!free || !box.inside(canvas)) continue;
        write(label, at, box, pad);
        return;
      }
    }
  }

  void write(const OverlayLabel& label, ImVec2 at, const Box& box, ImVec2 pad) {
    const ImVec2 nearest{std::clamp(at.x, box.min.x, box.max.x), std::clamp(at.y, box.min.y, box.max.y)};
    list_.AddLine(at, nearest, color_of(label.overlay, 120), std::max(1.0f, std::round(scale_)));
    list_.AddRectFilled(box.min, box.max, theme::color(theme::kDark, 215), 3 * scale_);
    list_.AddText({std::round(box.min.x + pad.x), std::round(box.min.y + pad.y)}, color_of(label.overlay),
                  label.text.c_str());
    taken_.push_back(box);
  }

  ImDrawList& list_;
  const CanvasView& view_;
  float scale_;
  float width_;
  std::vector<Box> taken_;
};

}  // namespace

void paint_overlays(ImDrawList& list, const OverlayDrawing& drawing, std::span<const Rect> keep_clear,
                    const CanvasView& view, float scale) {
  list.PushClipRect(view.min, view.max, true);
  Painter(list, view, scale).paint(drawing, keep_clear);
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
  Painter(list, view, size / 16).paint(sample, {});
}

}  // namespace talus
