#include "round_ground.h"

#include <algorithm>
#include <cmath>

#include "../../collision/ground_queries.h"

namespace talus {
namespace {

// px: a circle that is deeper in a side with no ground behind goes through it.
constexpr double kThrough = 1.0 / 16;

bool goes_through(const GroundSide& side, const SideNearness& here) {
  return side.is_thin && here.near.gap < -kThrough;
}

bool is_among(std::span<const GroundSide> sides, const GroundSide& one) {
  return std::any_of(sides.begin(), sides.end(), [&](const GroundSide& other) {
    return other.from == one.from && other.to == one.to && other.facing == one.facing;
  });
}

// Whether a circle on a path comes nearer to a straight side that it touches.
bool comes_nearer(const FallPath& path, Vec2 normal) {
  const double speed = -dot(path.velocity, normal);
  return speed > kStill || (speed >= -kStill && -dot(path.pull, normal) > kStill);
}

}  // namespace

Rect area_around(const Rect& a, const Rect& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return touch_area({x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y});
}

// Another side that goes on from the end that a circle touches, so that it does not touch the end alone;
// null: there is none.
const GroundSide* RoundGround::hides(std::size_t index, Vec2 middle, double radius) const {
  const Vec2 end = nearer_end(sides_[index], middle);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i == index || !(sides_[i].from == end || sides_[i].to == end)) continue;
    const SideNearness there = nearness(sides_[i], middle, radius);
    if (!there.near.on_end && there.in_front && !goes_through(sides_[i], there)) return &sides_[i];
  }
  return nullptr;
}

// The normal across a gap as wide as a circle, out of the end of a side, if the circle touches that end and
// one on the other side of the gap. The two hold nothing that goes along the gap. A circle touches both a
// little before its middle is between them, and their own normals would be those of a wedge.
std::optional<Vec2> RoundGround::across_gap(const GroundSide& side, const Form& form) const {
  const Vec2 middle = form.middle(), end = nearer_end(side, middle);
  const double slack = touch_slack(form.box, form.box);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Vec2 way = nearer_end(sides_[i], middle) - end;
    const double wide = std::sqrt(dot(way, way));
    if (!(wide >= 2 * form.radius - slack)) continue;
    const SideNearness here = nearness(sides_[i], middle, form.radius);
    if (!here.near.on_end || !here.in_front || here.near.gap > slack) continue;
    if (hides(i, middle, form.radius) == nullptr) return way * (1 / wide);
  }
  return std::nullopt;
}

const std::vector<SideTouch>& RoundGround::touched(const Form& form, CastBudget& budget) {
  return touched(form, touch_area(form.box), budget);
}

const std::vector<SideTouch>& RoundGround::touched(const Form& form, const Rect& area, CastBudget& budget) {
  // One contact asks several times for the same. It costs what it did.
  if (asked_.box == form.box && asked_.radius == form.radius && asked_area_ == area) {
    budget.left -= asked_cost_;
    return touched_;
  }
  const std::int64_t before = budget.left;
  touched_.clear();
  find_sides(ground_, area, budget, sides_);
  const Vec2 middle = form.middle();
  const double slack = touch_slack(form.box, form.box);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const SideNearness here = nearness(sides_[i], middle, form.radius);
    if (!here.in_front || here.near.gap > slack || goes_through(sides_[i], here)) continue;
    if (here.near.on_end && hides(i, middle, form.radius) != nullptr) continue;
    const auto across = here.near.on_end ? across_gap(sides_[i], form) : std::nullopt;
    SideTouch touch{sides_[i], here.near, across.has_value()};
    if (across) touch.near.normal = *across;
    touched_.push_back(touch);
  }
  asked_ = budget.left > 0 ? form : Form();
  asked_area_ = area;
  asked_cost_ = before - budget.left;
  return touched_;
}

std::optional<RoundTouch> RoundGround::time_to(const GroundSide& side, const MovingBox& box, double from,
                                               double to) const {
  const FallPath path = box.path.from(from);
  const Form start = box.form_at(from);
  const FallPath way{0, {}, path.velocity, path.pull};
  const double slack = touch_slack(start.box, start.box);
  const auto at = [&](double s) { return nearness(side, start.middle() + way.way_to(s), box.radius); };
  if (goes_through(side, at(0))) return std::nullopt;
  const auto near_at = [&](double s) { return at(s).near; };
  const auto met = first_touch({way, to - from, slack, kStill, side.is_hollow()}, near_at);
  if (!met || !at(met->time).in_front) return std::nullopt;
  return met;
}

// What a circle meets where its path leads to a side; nothing if it does not stop there. near: of the side
// then, there: the circle then.
std::optional<SideTouch> RoundGround::met_with(std::size_t index, const Nearness& near,
                                               const MovingBox& there,
                                               std::span<const GroundSide> along) const {
  SideTouch touch{sides_[index], near};
  if (!near.on_end) return touch;
  const Form form = there.form_at(there.path.time);
  if (const GroundSide* other = hides(index, form.middle(), form.radius)) {
    // It met this end before the hollow that goes on from there was looked at.
    touch = {*other, nearness(*other, form.middle(), form.radius).near};
    const bool meets = touch.near.gap <= touch_slack(form.box, form.box) &&
                       -dot(there.path.velocity, touch.near.normal) > kStill;
    if (is_among(along, *other) || !other->is_hollow() || !meets || touch.near.gap < -kThrough)
      return std::nullopt;
  } else if (const auto across = across_gap(touch.side, form)) {
    if (!comes_nearer(there.path, *across)) return std::nullopt;
    touch.near.normal = *across;
  }
  return touch;
}

std::optional<GroundMeeting> RoundGround::next_meeting(const MovingBox& box, double to,
                                                       std::span<const GroundSide> along, CastBudget& budget,
                                                       GroundSide& side) {
  constexpr double kSlice = 32;  // px, of a path: the sides near a long one would be many
  constexpr std::int64_t kSliceWork = 4;
  const double start = box.path.time;
  const Vec2 way = box.path.way_to(to);
  const double slices = std::ceil(std::max({1.0, std::abs(way.x) / kSlice, std::abs(way.y) / kSlice}));
  for (double i = 0; i < slices && budget.left > 0; ++i) {
    const double begin = start + (to - start) * (i / slices),
                 end = i + 1 == slices ? to : start + (to - start) * ((i + 1) / slices);
    budget.left -= kSliceWork;
    find_sides(ground_, area_around(box.at(begin), box.at(end)), budget, sides_);
    std::optional<GroundMeeting> first;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      if (is_among(along, sides_[k])) continue;
      const auto met = time_to(sides_[k], box, begin, end);
      if (!met || (first && begin + met->time >= first->time)) continue;
      const double time = begin + met->time;
      MovingBox there = box;
      there.path = box.path.from(time);
      const auto touch = met_with(k, met->near, there, along);
      if (!touch) continue;
      put_on(touch->side, there);
      const Form form = there.form_at(time);
      first = {time, touch->near.normal, form.box.position(), contact_with(*touch, form)};
      side = touch->side;
    }
    if (first) return first;
  }
  return std::nullopt;
}

std::optional<Vec2> RoundGround::way_out(const Form& form, CastBudget& budget) {
  Form there = form;
  const double small = form.radius / 64;
  const Vec2 middle = form.middle();
  const auto first =
      talus::way_out(ground_, {middle.x - small, middle.y - small, 2 * small, 2 * small}, Foot::box, &budget);
  const auto move = [&](Vec2 way) {
    there.box.x += way.x;
    there.box.y += way.y;
  };
  if (first) move(*first);
  constexpr int kMaxTries = 8;
  for (int i = 0; i < kMaxTries; ++i) {
    const auto& all = touched(there, budget);
    const auto deepest = std::min_element(all.begin(), all.end(), [](const SideTouch& a, const SideTouch& b) {
      return a.near.gap < b.near.gap;
    });
    if (deepest == all.end() || deepest->near.gap >= -touch_slack(there.box, there.box)) break;
    move(deepest->near.normal * -deepest->near.gap);
  }
  const Vec2 way = there.box.position() - form.box.position();
  return way == Vec2() ? std::nullopt : std::optional(way);
}

Contact<double> RoundGround::contact_with(const SideTouch& touch, const Form& form) const {
  const GroundSide& side = touch.side;
  Contact<double> contact;
  contact.t = 0;
  contact.position = form.box.position();
  contact.normal = touch.near.normal;
  contact.facing = side.facing;
  contact.piece = side.piece;
  contact.on_end = touch.near.on_end;
  contact.origin = side.origin;
  // Of tiles side by side, the one that it touches.
  if (side.piece == nullptr && side.along.x != 0) {
    const double last = std::round((side.to.x - side.from.x) * ground_.columns_per_px()) - 1;
    const double column = std::floor((form.middle().x - side.from.x) * ground_.columns_per_px());
    contact.origin += static_cast<std::int32_t>(std::clamp(column, 0.0, last));
  }
  return contact;
}

void put_on(const GroundSide& side, MovingBox& box) {
  FallPath& path = box.path;
  const Form form = box.form_at(path.time);
  const Nearness near = nearness(side, form.middle(), box.radius).near;
  constexpr double kRounding = 0x1p-50;  // share of a coordinate
  if (std::abs(near.gap) <= kRounding * (std::abs(path.place.x) + std::abs(path.place.y) + box.radius))
    return;
  if (near.normal.x == 0) {
    const double on_top = side.from.y - box.size.y;
    path.place.y = near.normal.y < 0 ? on_top : on_top + 2 * box.radius;
    if (near.on_end || side.stretch != nullptr) path.place.y = form.box.y - near.normal.y * near.gap;
  } else if (near.normal.y == 0 && !near.on_end && side.stretch == nullptr) {
    path.place.x = side.from.x + near.normal.x * box.radius - box.size.x / 2;
  } else {
    path.place = path.place - near.normal * near.gap;
  }
}

}  // namespace talus
