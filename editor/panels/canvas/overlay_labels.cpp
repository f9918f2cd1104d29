// Tries places around a label's point, near ones first.
#include "overlay_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "panels/ui/shown_text.h"

namespace talus {
namespace {

constexpr float kLowZoom = 2;  // at scale 1; at a lower zoom only the most important labels are shown
// px at scale 1: a label whose point is further from its body is moved towards the body.
constexpr float kPull = 12;
constexpr float kApart = 3;  // px at scale 1, between labels and what they avoid
constexpr int kRanks = 4;
constexpr int kSquaresOfWord = 64;

// The top of a list that was moved up until it covers no label.
float top_above(ScreenBox list, std::span<const PlacedLabel> placed) {
  const float height = list.max.y - list.min.y;
  const auto next = [&] {
    return std::find_if(placed.begin(), placed.end(),
                        [&](const PlacedLabel& p) { return p.box.meets(list); });
  };
  for (auto covered = next(); covered != placed.end(); covered = next()) {
    list.max.y = covered->box.min.y;
    list.min.y = list.max.y - height;
  }
  return list.min.y;
}

}  // namespace

bool ScreenBox::meets(const ScreenBox& b) const {
  return min.x < b.max.x && b.min.x < max.x && min.y < b.max.y && b.min.y < max.y;
}

bool ScreenBox::inside(const ScreenBox& b) const {
  return min.x >= b.min.x && min.y >= b.min.y && max.x <= b.max.x && max.y <= b.max.y;
}

ScreenBox ScreenBox::grown(float by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }

ImVec2 ScreenBox::nearest(ImVec2 p) const {
  return {std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y)};
}

bool ScreenBox::is_within(float reach, const ScreenBox& b) const {
  const float x = std::max({min.x - b.max.x, b.min.x - max.x, 0.0f});
  const float y = std::max({min.y - b.max.y, b.min.y - max.y, 0.0f});
  return x * x + y * y <= reach * reach;
}

float ScreenBox::distance(const ScreenBox& b) const {
  return std::hypot(std::max({min.x - b.max.x, b.min.x - max.x, 0.0f}),
                    std::max({min.y - b.max.y, b.min.y - max.y, 0.0f}));
}

TakenBoxes::TakenBoxes(const ScreenBox& canvas, std::span<const ScreenBox> boxes)
    : origin_(canvas.min),
      columns_(std::max(1, static_cast<int>(std::ceil((canvas.max.x - canvas.min.x) / kCell)))),
      rows_(std::max(1, static_cast<int>(std::ceil((canvas.max.y - canvas.min.y) / kCell)))),
      words_(static_cast<std::size_t>(columns_ + kSquaresOfWord - 1) / kSquaresOfWord),
      bits_(words_ * static_cast<std::size_t>(rows_)) {
  for (const ScreenBox& box : boxes) add(box);
}

template <class Visit>
bool TakenBoxes::any_word(const ScreenBox& box, Visit visit) const {
  const auto square = [](float at, float origin, int count) {
    return static_cast<int>(std::clamp(std::floor((at - origin) / kCell), -1.0f, static_cast<float>(count)));
  };
  const int x0 = std::max(square(box.min.x, origin_.x, columns_), 0);
  const int x1 = std::min(square(box.max.x, origin_.x, columns_), columns_ - 1);
  const int y0 = std::max(square(box.min.y, origin_.y, rows_), 0);
  const int y1 = std::min(square(box.max.y, origin_.y, rows_), rows_ - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int word = x0 / kSquaresOfWord; x0 <= x1 && word <= x1 / kSquaresOfWord; ++word) {
      const int first = std::max(x0 - word * kSquaresOfWord, 0),
                last = std::min(x1 - word * kSquaresOfWord, kSquaresOfWord - 1);
      const std::uint64_t bits =
          (~std::uint64_t{0} << first) & (~std::uint64_t{0} >> (kSquaresOfWord - 1 - last));
      if (visit(static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(word), bits)) return true;
    }
  }
  return false;
}

void TakenBoxes::add(const ScreenBox& box) {
  any_word(box, [&](std::size_t word, std::uint64_t bits) {
    bits_[word] |= bits;
    return false;
  });
}

bool TakenBoxes::meet(const ScreenBox& box) const {
  return any_word(box, [&](std::size_t word, std::uint64_t bits) { return (bits_[word] & bits) != 0; });
}

std::vector<PlacedLabel> LabelPlacer::place(std::span<const OverlayLabel> labels) {
  std::vector<PlacedLabel> placed;
  std::vector<const OverlayLabel*> chosen, pointed;  // labels without room
  std::unordered_set<int> crowded;  // bodies with another such label: crowds cost the most time there
  for (int rank = 0; rank < kRanks; ++rank) {
    for (const OverlayLabel& label : labels) {
      const ImVec2 at = view_.to_screen(label.at);
      if (rank_of(label) != rank || (rank > 0 && crowded.contains(label.body)) ||
          is_said(label, placed, {at, at}))
        continue;
      if (const auto found = find_room(label)) {
        if (rank > 0 && is_said(label, placed, found->box)) continue;
        taken_.add(found->box);
        placed.push_back(*found);
      } else if (label.body == pointed_at_) {
        pointed.push_back(&label);
      } else if (label.important && body_of(label).meets({view_.min, view_.max})) {
        chosen.push_back(&label);
      } else {
        crowded.insert(label.body);
      }
    }
  }
  list(pointed, placed);
  list(chosen, placed);
  return placed;
}

// Whether an equal label of the same overlay stands near a place: one is enough for both.
bool LabelPlacer::is_said(const OverlayLabel& label, std::span<const PlacedLabel> placed,
                          const ScreenBox& place) const {
  return std::any_of(placed.begin(), placed.end(), [&](const PlacedLabel& other) {
    return other.label->overlay == label.overlay && other.label->text == label.text &&
           other.box.is_within(kLabelReach * scale_, place);
  });
}

// The rank of a label. Low ranks find room first: those of the chosen body and of the one under the mouse,
// then the rarer ones. kRanks: left out.
int LabelPlacer::rank_of(const OverlayLabel& label) const {
  if (label.important || (label.body != 0 && label.body == pointed_at_)) return 0;
  if (view_.zoom < kLowZoom * scale_) return kRanks;
  const Rect& b = label.body_box;
  const bool is_inside = label.overlay->labels_outside && label.at.x >= b.x && label.at.x <= b.right() &&
                         label.at.y >= b.y && label.at.y <= b.bottom();
  return is_inside ? kRanks : label.overlay->label_rank;
}

std::optional<PlacedLabel> LabelPlacer::find_room(const OverlayLabel& label) const {
  const ImVec2 size = size_of(label);
  const ScreenBox canvas{view_.min, view_.max}, body = body_of(label);
  const ImVec2 at = body.grown(kPull * scale_).nearest(view_.to_screen(label.at));
  for (float gap = 6 * scale_; gap < kLabelReach * scale_; gap += 8 * scale_) {
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
    if (label.overlay->labels_above) std::swap(corners[0], corners[4]);
    for (ImVec2 corner : corners) {
      const ScreenBox box{corner, {corner.x + size.x, corner.y + size.y}};
      if (box.inside(canvas) && box.is_within(kLabelReach * scale_, body) && is_free(box))
        return PlacedLabel{&label, box, at};
    }
  }
  return std::nullopt;
}

bool LabelPlacer::is_free(const ScreenBox& box) const { return !taken_.meet(box.grown(kApart * scale_)); }

// Below one another beside their body, over whatever else is there.
void LabelPlacer::list(std::span<const OverlayLabel* const> labels, std::vector<PlacedLabel>& placed) const {
  if (labels.empty()) return;
  ImVec2 all{0, 0};
  for (const OverlayLabel* label : labels) {
    const ImVec2 size = size_of(*label);
    all = {std::max(all.x, size.x), all.y + size.y};
  }
  const ScreenBox body = body_of(*labels.front()).grown(kPull * scale_);
  ImVec2 at{body.max.x, body.min.y - all.y};
  if (at.x + all.x > view_.max.x) at.x = body.min.x - all.x;
  at.y = top_above({at, {at.x + all.x, at.y + all.y}}, placed);
  if (at.y < view_.min.y) at.y = body.max.y;
  at.x = std::max(std::min(at.x, view_.max.x - all.x), view_.min.x);
  at.y = std::max(std::min(at.y, view_.max.y - all.y), view_.min.y);
  for (const OverlayLabel* label : labels) {
    const float height = size_of(*label).y;
    placed.push_back({label, {at, {at.x + all.x, at.y + height}}, {}});
    at.y += height;
  }
}

ImVec2 LabelPlacer::size_of(const OverlayLabel& label) const {
  const ImVec2 text = size_of_text(label.text);
  return {text.x + 2 * padding().x, text.y + 2 * padding().y};
}

ScreenBox LabelPlacer::body_of(const OverlayLabel& label) const {
  const Rect& b = label.body_box;
  return {view_.to_screen({b.x, b.y}), view_.to_screen({b.right(), b.bottom()})};
}

}  // namespace talus
