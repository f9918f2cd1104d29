// Strokes lines, boxes, marks, bars and labels in level pixels onto a canvas.
#include "overlay_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "overlay/overlay_pen.h"
#include "overlay_labels.h"
#include "panels/ui/shown_text.h"
#include "panels/ui/theme.h"

namespace talus {
namespace {

// At scale 1; at a lower zoom some lines are shorter.
constexpr float kShortZoom = 4;
// At scale 1; at a lower zoom all is thinner, as bodies are hardly larger than marks.
constexpr float kThinZoom = 2;
constexpr float kPiece = 16;  // px at scale 1: lines are kept free of labels in pieces of this length
constexpr int kMaxPieces = 64;
constexpr std::ptrdiff_t kCrowd = 100;  // arrows, or marks; of more than this only some are drawn
constexpr float kRoomInCrowd = 48;  // px at scale 1: then an overlay has one that begins in each such square

class Painter {
 public:
  Painter(ImDrawList& list, const CanvasView& view, float scale, int pointed_at, OverlayPalette palette)
      : list_(list),
        view_(view),
        palette_(palette),
        scale_(scale),
        pointed_at_(pointed_at),
        is_low_(view.zoom < kThinZoom * scale),
        width_(std::max(1.0f, std::round(scale * (is_low_ ? 1.0f : 1.5f)))) {}

  void paint(const OverlayDrawing& drawing, std::span<const Rect> keep_clear) {
    for (const OverlayBox& box : drawing.boxes) paint_box(box);
    const std::vector<const OverlayLine*> lines = shown_lines(drawing.lines);
    for (const OverlayLine* line : lines)
      if (!line->overlay->is_faint) stroke(*line, outline(), width_ + 2 * rim());
    for (const OverlayLine* shown : lines) {
      const OverlayLine& line = *shown;
      const int alpha = static_cast<int>(255 * std::clamp(line.strength, 0.0, 1.0));
      stroke(line, color_of(line.overlay, alpha), line.overlay->is_faint ? rim() : width_);
    }
    for (const OverlayBar& bar : drawing.bars) paint_bar(bar);
    Squares squares(*this);
    const bool is_crowd = std::ssize(drawing.marks) > kCrowd;
    for (const OverlayMark& mark : drawing.marks)
      if (!is_crowd || squares.take(mark.overlay, mark.at)) paint_mark(mark);
    for (const Rect& rect : keep_clear) taken_.push_back(screen_box(rect));
    keep_clear_of(drawing, lines);
    paint_labels(drawing.labels);
    if (drawing.is_cut) paint_note("too much in view: some overlays are left out");
  }

 private:
  ImU32 color_of(const Overlay* overlay, int alpha = 255) const {
    return theme::color(overlay_color(*overlay, palette_), alpha);
  }
  static ImU32 outline() { return theme::color(theme::kDark, 190); }

  // The squares of the canvas, each for one thing of each overlay.
  class Squares {
   public:
    explicit Squares(const Painter& painter) : painter_(painter) {}
    // place: px of the level. Returns false if its square is taken.
    bool take(const Overlay* overlay, Vec2 place) {
      const ImVec2 at = painter_.view_.to_screen(place);
      const float side = kRoomInCrowd * painter_.scale_;
      return taken_
          .emplace(overlay, static_cast<int>(std::floor(at.x / side)),
                   static_cast<int>(std::floor(at.y / side)))
          .second;
    }

   private:
    const Painter& painter_;
    std::set<std::tuple<const Overlay*, int, int>> taken_;
  };

  // Without details at low zoom. Of many arrows those stay that begin apart from the others of their overlay.
  std::vector<const OverlayLine*> shown_lines(std::span<const OverlayLine> lines) const {
    const bool is_crowd = std::count_if(lines.begin(), lines.end(),
                                        [](const OverlayLine& line) { return line.arrow; }) > kCrowd;
    Squares squares(*this);
    std::vector<const OverlayLine*> shown;
    for (const OverlayLine& line : lines) {
      if (is_low_ && line.detail) continue;
      if (is_crowd && line.arrow && !squares.take(line.overlay, line.from)) continue;
      shown.push_back(&line);
    }
    return shown;
  }
  float arm() const { return (is_low_ ? 2.5f : 4.0f) * scale_; }  // length of a mark's arm
  float rim() const { return std::max(1.0f, std::round(scale_ * 0.75f)); }

  void paint_box(const OverlayBox& box) {
    const ImVec2 from = view_.to_screen({box.box.x, box.box.y});
    const ImVec2 to = view_.to_screen({box.box.right(), box.box.bottom()});
    if (box.filled) {
      list_.AddRectFilled(from, to, color_of(box.overlay, static_cast<int>(70 * box.strength)));
      list_.AddRect(from, to, color_of(box.overlay, static_cast<int>(std::min(150 * box.strength, 255.0))));
      return;
    }
    if (!is_low_) list_.AddRect(from, to, outline(), 0, 0, width_ + 2 * rim());
    list_.AddRect(from, to, color_of(box.overlay), 0, 0, width_);
  }

  void stroke(const OverlayLine& line, ImU32 color, float width) {
    const auto [from, to] = ends(line);
    list_.AddLine(from, to, color, width);
    if (!line.arrow) return;
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length < 1) return;
    const float head = std::min((is_low_ ? 3.5f : 6.0f) * scale_, length * 0.7f);
    const float ux = dx / length * head, uy = dy / length * head;
    const std::array<ImVec2, 3> points = {
        {{to.x - ux + uy * 0.6f, to.y - uy - ux * 0.6f}, to, {to.x - ux - uy * 0.6f, to.y - uy + ux * 0.6f}}};
    list_.AddPolyline(points.data(), static_cast<int>(points.size()), color, ImDrawFlags_None, width);
  }

  void paint_mark(const OverlayMark& mark) {
    const ImVec2 at = view_.to_screen(mark.at);
    const float arm = this->arm();
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

  // The thing that a label is about must stay visible.
  void keep_clear_of(const OverlayDrawing& drawing, std::span<const OverlayLine* const> lines) {
    for (const OverlayBar& bar : drawing.bars) taken_.push_back(screen_box(bar.box));
    for (const OverlayLine* line : lines)
      if (!line->overlay->covers_much) keep_clear_of(*line);  // else no label would find room
    for (const OverlayMark& mark : drawing.marks) {
      const ImVec2 at = view_.to_screen(mark.at);
      const float arm = this->arm();
      taken_.push_back({{at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}});
    }
  }
  ScreenBox screen_box(Rect rect) const {
    return {view_.to_screen({rect.x, rect.y}), view_.to_screen({rect.right(), rect.bottom()})};
  }

  void keep_clear_of(const OverlayLine& line) {
    const auto way = ends(line);
    const ImVec2 from = way.first;
    const float dx = way.second.x - from.x, dy = way.second.y - from.y;
    const int pieces =
        std::clamp(static_cast<int>(std::ceil(std::hypot(dx, dy) / (kPiece * scale_))), 1, kMaxPieces);
    const auto at = [&](int i) {
      const float part = static_cast<float>(i) / static_cast<float>(pieces);
      return ImVec2{from.x + dx * part, from.y + dy * part};
    };
    for (int i = 0; i < pieces; ++i) {
      const ImVec2 a = at(i), b = at(i + 1);
      const ScreenBox box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
      taken_.push_back(box.grown(width_));
    }
  }

  // Where a line is on the screen.
  std::pair<ImVec2, ImVec2> ends(const OverlayLine& line) const {
    const ImVec2 from = view_.to_screen(line.from), to = view_.to_screen(line.to);
    if (!line.overlay->is_short_from_far) return {from, to};
    const float part = std::min(1.0f, view_.zoom / (kShortZoom * scale_));
    return {from, {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part}};
  }

  void paint_labels(std::span<const OverlayLabel> labels) {
    LabelPlacer placer(view_, scale_, pointed_at_, taken_);
    for (const PlacedLabel& placed : placer.place(labels)) {
      const ScreenBox& box = placed.box;
      const Overlay* overlay = placed.label->overlay;
      const ImVec2 pad = placer.padding();
      if (placed.point)
        list_.AddLine(*placed.point, box.nearest(*placed.point), color_of(overlay, 120),
                      std::max(1.0f, std::round(scale_)));
      list_.AddRectFilled(box.min, box.max, theme::color(theme::kDark, theme::kPlateAlpha), 3 * scale_);
      add_text(list_, {std::round(box.min.x + pad.x), std::round(box.min.y + pad.y)},
               theme::color(overlay_text_color(*overlay, palette_)), placed.label->text);
    }
  }

  // In the bottom right corner.
  void paint_note(std::string_view text) {
    const ImVec2 size = size_of_text(text), pad{6 * scale_, 2 * scale_};
    const ImVec2 max{view_.max.x - 4 * scale_, view_.max.y - 4 * scale_};
    const ImVec2 min{max.x - size.x - 2 * pad.x, max.y - size.y - 2 * pad.y};
    list_.AddRectFilled(min, max, theme::color(theme::kDark, theme::kPlateAlpha), 3 * scale_);
    add_text(list_, {min.x + pad.x, min.y + pad.y}, theme::color(theme::kWarning), text);
  }

  ImDrawList& list_;
  const CanvasView& view_;
  OverlayPalette palette_;
  float scale_;
  int pointed_at_;
  bool is_low_;
  float width_;
  std::vector<ScreenBox> taken_;
};

}  // namespace

void paint_overlays(ImDrawList& list, const OverlayDrawing& drawing, std::span<const Rect> keep_clear,
                    const CanvasView& view, float scale, int pointed_at) {
  list.PushClipRect(view.min, view.max, true);
  Painter(list, view, scale, pointed_at, drawing.palette).paint(drawing, keep_clear);
  list.PopClipRect();
}

void paint_overlay_swatch(ImDrawList& list, const Overlay& overlay, ImVec2 at, float size,
                          OverlayPalette palette) {
  // The colours are made for dark ground.
  if (theme::is_light())
    list.AddRectFilled({at.x - 1, at.y - 1}, {at.x + size + 1, at.y + size + 1},
                       theme::color(theme::kOutside));
  // The swatch is a canvas of 8 by 8 level pixels that holds one piece of the overlay.
  const CanvasView view{at, {at.x + size, at.y + size}, {at.x, at.y}, size / 8};
  OverlayDrawing sample;
  OverlayPen pen(overlay, {0, 0, 8, 8}, sample);
  if (overlay.draw_swatch != nullptr) overlay.draw_swatch(pen);
  Painter(list, view, size / 16, 0, palette).paint(sample, {});
}

}  // namespace talus
