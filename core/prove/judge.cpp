#include "judge.h"

#include <array>
#include <cmath>

namespace talus {
namespace {

// px; how far ahead it is looked whether a body could go on.
constexpr Fine kAhead = kFinePx / 32, kAheadOnCurve = kFinePx / 4;
// px; rounding of a place on a map, far more than doubles lose. What floats do, in sizes of the map.
constexpr Fine kSlack = kFinePx >> 14;
constexpr Fine kRounding = 4;  // of a few sums of such numbers
constexpr double kFloatRounding = 1.0 / (1 << 19);
constexpr Fine kChord = kFinePx / 64;    // a curve may be so far from the chord along which a step goes
constexpr double kSteepGround = 16;      // |dy/dx| of slopes down which bodies on their centre slide
constexpr Fine kDeep = 16;               // a middle that is less than so many roundings in a slope touches it
constexpr Fine kMaxBevel = 4 * kFinePx;  // the width of a low edge that is not upright
constexpr int kMaxRises = 16;            // parts that a body is lifted over, one after the other
constexpr int kDeepestFloor = 8;         // widths of a body; so far below it may be the floor that leads on
constexpr double kSameSpeed = 1e-6;
constexpr Fine kEndSlacks = 10;  // so many roundings below a floor's end a body has touched it
// So far ahead a rise to a ceiling is looked for.
constexpr std::array<Fine, 2> kRiseWays = {kAhead, kFinePx};

Fine scaled(Fine length, double factor) { return std::llround(static_cast<double>(length) * factor); }

// px, to 1/1024: edges are measured a little beside the body.
// What of a box stands on floors.
FineBox foot_of(const FineBox& box, Foot foot) { return foot == Foot::centre ? box.middle_line() : box; }

// The x in which a part and a box meet; both must share some.
std::array<Fine, 2> shared_x(const RawPart& part, const FineBox& box) {
  return {std::clamp(part.top.x0, box.x0, box.x1), std::clamp(part.top.x1, box.x0, box.x1)};
}

// px, rounding of a place for the numbers of the solver.
Fine slack_of(const RawGround& ground, const Tuning& tuning) {
  if (tuning.solver != SolverKind::exact || tuning.exact.single_precision == 0) return kSlack;
  const TileSize tile = ground.tile_size();
  const double size = 1.0 * ground.columns() * tile.width + 1.0 * ground.rows() * tile.height;
  return std::max(kSlack, fine(size * kFloatRounding));
}

}  // namespace

Judge::Judge(const RawGround& ground, const Tuning& tuning, double lip)
    : ground_(ground),
      tuning_(tuning),
      slack_(slack_of(ground, tuning)),
      weld_(kFinePx / kWeldParts + scaled(4 * slack_, tuning.exact.steepest) + slack_),
      least_weld_(kFinePx / kWeldParts + kRounding),
      ahead_(std::max(kAhead, 64 * slack_)),
      lip_(fine(lip)) {}

std::optional<Verdict> Judge::judge(const Body& before, const Body& after, const Input& input,
                                    const StepRecord& record) const {
  // Where its foot is beyond the map, there is no ground to judge it by.
  if (!ground_.has_row_at(fine_box(after.box).y1 - weld_)) return std::nullopt;
  if (comes_into_ground(before, after)) return Verdict{FindingKind::inside};
  if (falls_through(before, after)) return Verdict{FindingKind::falls_through};
  const bool walks = is_walker(after);
  if (walks && after.gait.grounded && !has_floor_at_foot(after, Under::corners))
    return Verdict{FindingKind::floats};
  const bool jumps = input.jump && !before.gait.jump_held;
  if (walks && before.gait.grounded && !jumps) {
    const PlayerTuning& player = tuning_.player;
    const int direction = (input.right ? 1 : 0) - (input.left ? 1 : 0);
    const double target = player.run_speed * direction, v = before.velocity.x;
    const double gain = direction == 0 ? player.run_loss : player.run_gain;
    return judge_walk(before, after, v < target ? std::min(v + gain, target) : std::max(v - gain, target),
                      record);
  }
  if (auto met = judge_contacts(before, record, walks && before.gait.grounded)) return met;
  return judge_roll(before, after);
}

bool Judge::comes_into_ground(const Body& before, const Body& after) const {
  return !is_free(after.box, after.foot, Corners::in_any_floor) &&
         is_free(before.box, before.foot, Corners::in_any_floor);
}

std::optional<Verdict> Judge::judge_walk(const Body& before, const Body& after, double speed,
                                         const StepRecord& record) const {
  if (speed == 0) return std::nullopt;
  const int direction = speed < 0 ? -1 : 1;
  const double steepest = tuning_.exact.steepest, most = std::abs(speed), slack = px_of(weld_);
  const double least =
      tuning_.player.surface_speed != 0 ? most / std::hypot(1.0, steepest_on_curve(steepest)) : most;
  const double moved = (after.box.x - before.box.x) * direction, rise = before.box.y - after.box.y;
  if (moved > most + slack && !has_landed_on_curve(before, after, direction))
    return Verdict{FindingKind::jumps, moved - most};
  // A curve may get steeper within the step.
  if (rise > most * steepest + slack &&
      !ground_.has_curve_in(hull(fine_box(before.box), fine_box(after.box))))
    return Verdict{FindingKind::jumps, rise - most * steepest};
  if (!after.gait.grounded) {
    if (floor_goes_on(before, after, direction)) return Verdict{FindingKind::leaves_floor};
    return gap_after(before, direction);
  }
  if (auto missed = ramp_missed(before, after, direction)) return missed;
  const bool slows = std::abs(after.velocity.x - speed) > kSameSpeed;
  if (moved >= least - slack && !slows) return std::nullopt;
  if (is_stopped_before(before, after, direction, record)) return judge_stop(after, direction);
  const Ahead ahead = ahead_of(after, direction);
  if (ahead.way == Way::blocked) return std::nullopt;
  if (ahead.way == Way::lip) return lip_of(direction, ahead.edge);
  if (!slows && moved >= most / std::hypot(1.0, steepest_on_curve(steepest)) - slack &&
      has_landed_on_curve(before, after, direction))
    return std::nullopt;
  if (rises_to_ceiling(fine_box(after.box), after.foot, direction)) return std::nullopt;
  if (moved >= least - slack) return Verdict{FindingKind::slows, most - after.velocity.x * direction};
  return Verdict{FindingKind::stops, least - moved};
}

// Whether a body has left its floor and come to a curve within a step: what lands on a curve goes its way
// along the curve, not to the side.
bool Judge::has_landed_on_curve(const Body& before, const Body& after, int direction) const {
  return ground_.has_curve_in(hull(fine_box(before.box), fine_box(after.box))) &&
         !floor_goes_on(before, after, direction);
}

// Whether the floor of a body leads just ahead, rising by hardly anything further on, to where a ceiling
// leaves the body no room.
bool Judge::rises_to_ceiling(const FineBox& box, Foot foot, int direction) const {
  const Fine most = weld_ + scaled(kAhead, tuning_.exact.steepest);
  return std::any_of(kRiseWays.begin(), kRiseWays.end(), [&](Fine way) {
    const FineBox next = box.moved(direction * way, 0);
    const auto floor = floor_near(next, foot, most, scaled(way, tuning_.exact.steepest));
    const FineBox there = next.moved(0, floor ? *floor - box.y1 : 0);
    return floor && !passes(there, there, foot);
  });
}

// Of a body that something there has stopped: it ought not to if it is too steep, but low.
std::optional<Verdict> Judge::judge_stop(const Body& after, int direction) const {
  const auto bevel = bevel_at(fine_box(after.box), after.foot, direction);
  if (!bevel || bevel->height > lip_ + slack_) return std::nullopt;
  return lip_of(direction, *bevel);
}

// A one-way floor that leads up, or goes on where the body's own floor ends, and begins so little above that
// floor that it is meant to go on from it: the body has gone under it.
std::optional<Verdict> Judge::ramp_missed(const Body& before, const Body& after, int direction) const {
  if (!after.gait.grounded) return std::nullopt;
  const FineBox inner = inside_of(after);
  const Fine bottom = fine_box(after.box).y1;
  std::optional<Verdict> missed;
  ground_.for_parts(inner, [&](const RawPart& part) {
    if (part.kind != RawPart::Kind::floor || !part.meets(inner)) return true;
    const RawLine& top = part.top;
    const Fine x = direction > 0 ? top.x0 : top.x1, y = direction > 0 ? top.y0 : top.y1;
    const Fine height = bottom - y;
    if (height > lip_ + slack_) return true;
    if (top.highest(top.x0, top.x1) >= y) {
      const auto line = height > weld_ ? floor_under(before) : std::nullopt;
      if (!line || std::abs(line->end(direction) - x) > weld_) return true;
    }
    if (height <= weld_) {
      if (is_walker(after) && leads_to(before, x, y, direction) && goes_under(part, after))
        missed = Verdict{FindingKind::leaves_floor};
      return !missed;
    }
    if (has_floor_to(x, y, direction)) return true;
    missed = lip_of(direction, {height, x, y});
    return false;
  });
  if (missed && is_across_line(before)) return std::nullopt;
  return missed;
}

// Whether one part of the ground leads from under the front of a body to a point.
bool Judge::leads_to(const Body& body, Fine x, Fine y, int direction) const {
  const FineBox box = fine_box(body.box), under = foot_of(box, body.foot);
  const Fine front = direction > 0 ? under.x1 : under.x0;
  if ((x - front) * direction < 0) return false;
  return !ground_.for_parts(
      {front - weld_, box.y1 - weld_, front + weld_, box.y1 + weld_}, [&](const RawPart& part) {
        const RawLine& top = part.top;
        const bool has_both = top.x0 <= std::min(front, x) && top.x1 >= std::max(front, x);
        return !(part.is_floor() && has_both && std::abs(top.at(front) - box.y1) <= weld_ &&
                 std::abs(top.at(x) - y) <= least_weld_);
      });
}

// Whether a body is under a one-way floor on which it had room.
bool Judge::goes_under(const RawPart& part, const Body& body) const {
  const FineBox box = fine_box(body.box), under = foot_of(box, body.foot);
  const auto [from, to] = shared_x(part, under);
  const Fine top = part.top.highest(from, to);
  if (part.top.is_steeper_than(tuning_.exact.steepest, from) || top >= box.y1 - 2 * weld_) return false;
  const FineBox there = box.moved(0, top - box.y1);
  return passes(there, there, body.foot);
}

// The floor on which a body stands, as far to both sides as the body is wide, from where it is the nearest to
// the body's middle.
std::optional<FloorLine> Judge::floor_under(const Body& body) const {
  const FineBox box = fine_box(body.box);
  const Fine width = box.x1 - box.x0;
  std::optional<Fine> foot;
  ground_.for_parts({box.x0, box.y1 - weld_, box.x1, box.y1 + weld_}, [&](const RawPart& part) {
    const Fine x = std::clamp(box.middle(), part.top.x0, part.top.x1);
    const bool holds = part.is_floor() && std::abs(part.top.at(x) - box.y1) <= weld_;
    if (holds && (!foot || std::abs(x - box.middle()) < std::abs(*foot - box.middle()))) foot = x;
    return true;
  });
  if (!foot) return std::nullopt;
  const FloorLine line(ground_, *foot, box.y1, *foot - width, *foot + width, tuning_.exact.steepest, weld_);
  return line.is_empty() ? std::nullopt : std::optional(line);
}

// The gap at the end of the floor on which a body stood, if a floor goes on behind it at about that height,
// and the body is too wide to fall through.
std::optional<Verdict> Judge::gap_after(const Body& before, int direction) const {
  const FineBox box = fine_box(before.box);
  const Fine width = box.x1 - box.x0;
  const auto line = floor_under(before);
  if (!line) return std::nullopt;
  const Fine end = line->end(direction), y = line->at_end(direction, box.y1);
  const Fine last = end + direction * width;
  std::optional<Fine> narrowest;
  ground_.for_parts({std::min(end, last), y - lip_, std::max(end, last), y + lip_}, [&](const RawPart& part) {
    const Fine begin = direction > 0 ? part.top.x0 : part.top.x1, top = part.top.at(begin);
    const Fine gap = (begin - end) * direction;
    const bool goes_on = part.is_floor() && gap > weld_ && gap < width && std::abs(top - y) <= lip_ &&
                         !part.top.is_steeper_than(tuning_.exact.steepest, begin);
    if (goes_on && (!narrowest || gap < *narrowest) && !has_floor_to(begin, top, direction)) narrowest = gap;
    return true;
  });
  if (!narrowest) return std::nullopt;
  return Verdict{FindingKind::gap, rounded_px(px_of(*narrowest)), Vec2{px_of(end), rounded_px(px_of(y))},
                 -direction};
}

// Whether a floor leads to this point in a direction.
bool Judge::has_floor_to(Fine x, Fine y, int direction) const {
  return !ground_.for_parts({x - weld_, y - weld_, x + weld_, y + weld_}, [&](const RawPart& part) {
    const bool comes = direction > 0 ? part.top.x0 < x - weld_ : part.top.x1 > x + weld_;
    return !part.is_floor() || !comes || std::abs(part.top.at(x) - y) > weld_;
  });
}

// Whether it met something that is there, and that explains a stop: a slope that is too steep, or something
// beside the place from which it was put on a floor.
bool Judge::is_stopped_before(const Body& before, const Body& after, int direction,
                              const StepRecord& record) const {
  return std::any_of(record.contacts.begin(), record.contacts.end(), [&](const ContactRecord& contact) {
    const bool was_put = std::abs(contact.touch.y - after.box.y) > px_of(weld_);
    return contact.normal.x * direction < 0 && (is_steep(contact.normal) || was_put) &&
           is_there(contact, before);
  });
}

// jumps: it leaves its floor by a jump. Low edges there are found by those who walk.
std::optional<Verdict> Judge::judge_contacts(const Body& before, const StepRecord& record, bool jumps) const {
  for (const ContactRecord& contact : record.contacts) {
    // A curve that leaves the map may be met just beyond the edge, where there is no ground to judge it by.
    const bool is_ground = contact.handled && !contact.overlaps && contact.other.body == 0 &&
                           ground_.has_row_at(fine(contact.touch.y + before.box.h) - weld_);
    const bool is_placed = tuning_.solver == SolverKind::article && contact.slope.has_value();
    if (is_ground && !is_placed && !is_there(contact, before)) return Verdict{FindingKind::ghost};
    const bool is_exact = tuning_.solver == SolverKind::exact,
               is_bevel = is_exact && is_steep(contact.normal);
    if (is_ground && is_exact && is_below_floor(before, contact)) return Verdict{FindingKind::stops};
    if (is_ground && !jumps && (contact.normal.y == 0 || is_bevel))
      if (const auto lip = lip_met(before, contact)) return lip;
  }
  return std::nullopt;
}

// Whether a body on its centre has met a side that lies below the floor below its middle.
bool Judge::is_below_floor(const Body& body, const ContactRecord& contact) const {
  if (body.foot != Foot::centre || contact.normal.y != 0) return false;
  const FineBox touch = fine_box({contact.touch.x, contact.touch.y, body.box.w, body.box.h});
  // Not in what it touches, by rounding.
  const FineBox box = touch.moved(scaled(slack_, contact.normal.x), 0);
  const FineBox next = box.moved(scaled(ahead_, -contact.normal.x), 0);
  const Fine rise = scaled(ahead_, tuning_.exact.steepest) + weld_,
             deepest = kDeepestFloor * (box.x1 - box.x0);
  const auto here = floor_near(box, body.foot, weld_, deepest);
  const auto floor = floor_near(next, body.foot, rise, deepest);
  const Fine from = box.middle(), middle = next.middle();
  // It may be below a one-way floor that leads there, or before the end of a line just above its floor, and a
  // slope on which nobody stands may be between the two.
  if (!here || !floor || *here - *floor > rise) return false;
  const FloorLine line(ground_, from, *here, std::min(from, middle), std::max(from, middle),
                       tuning_.exact.steepest, least_weld_);
  if (!line.reaches(from, middle) || std::abs(line.at(middle) - *floor) > weld_) return false;
  if (has_floor_in({middle, next.y1 - rise, middle, *floor - 1})) return false;
  // What it touches by rounding alone stops it, too.
  const auto passes_at = [&](Fine y) {
    const FineBox goal = next.moved(0, std::min(y, *floor - next.y1));
    return passes(box.moved(0, y), goal, body.foot, *floor);
  };
  return passes_at(0) && passes_at(-4 * slack_) && passes_at(4 * slack_);
}

// Whether it is that of a slope on which nobody stands.
bool Judge::is_steep(Vec2 normal) const {
  return normal.y < 0 && normal.x != 0 && std::abs(normal.x) > tuning_.exact.steepest * std::abs(normal.y);
}

// Of a body that rolls along a floor.
std::optional<Verdict> Judge::judge_roll(const Body& before, const Body& after) const {
  const double moved = after.box.x - before.box.x;
  const bool rolls = tuning_.solver == SolverKind::exact && after.gait.grounded && moved != 0 &&
                     has_floor_at_foot(before, Under::middle_of_slopes) &&
                     has_floor_at_foot(after, Under::middle_of_slopes);
  return rolls ? ramp_missed(before, after, moved < 0 ? -1 : 1) : std::nullopt;
}

bool Judge::is_free(const Rect& box, Foot foot, Corners corners) const {
  return is_free(box, foot, corners, slack_);
}

// slack: px, a body that is less deep in the ground is not in it.
bool Judge::is_free(const Rect& box, Foot foot, Corners corners, Fine slack) const {
  const FineBox whole = fine_box(box), inner = whole.shrunk(slack), middle = inner.middle_line();
  const FineBox core{middle.x0, middle.y0 + kDeep * slack, middle.x1, middle.y1 - kDeep * slack};
  // Beside the middle, corners are in the tiles that slopes lead to, and in slopes of any height.
  const Fine sunk = scaled((whole.x1 - whole.x0) / 2, std::max(tuning_.exact.steepest, kSteepGround));
  const FineBox between{inner.x0, inner.y0 + sunk, inner.x1, inner.y1 - sunk};
  std::optional<FloorLine> line;
  return ground_.for_parts(inner, [&](const RawPart& part) {
    if (part.kind != RawPart::Kind::solid || !part.meets(inner)) return true;
    const bool has_middle = part.meets(core.moved(-slack, 0)) && part.meets(core.moved(slack, 0));
    if (foot == Foot::box || has_middle) return false;
    const bool is_deep = between.y0 < between.y1 && !part.is_sloped() && part.meets(between);
    if (corners == Corners::in_any_floor && !is_deep) return true;
    if (!line) line = floor_line(whole, whole.y1, weld_);
    const auto [from, to] = shared_x(part, whole);
    return line->covers(part, from, to);
  });
}

bool Judge::touches(const Rect& box, Foot foot) const {
  FineBox grown = foot_of(fine_box(box).shrunk(slack_), foot);
  grown.y0 -= 2 * slack_;
  grown.y1 += 2 * slack_;
  return !ground_.for_parts(grown, [&](const RawPart& part) { return !part.meets(grown); });
}

// The floor that is the highest under the foot, from `up` above to `down` below the bottom of the box.
std::optional<Fine> Judge::floor_near(const FineBox& box, Foot foot, Fine up, Fine down) const {
  const FineBox under = foot_of(box, foot);
  std::optional<Fine> best;
  ground_.for_parts({under.x0, box.y1 - up, under.x1, box.y1 + down}, [&](const RawPart& part) {
    if (!part.is_floor() || part.top.x1 <= under.x0 || part.top.x0 >= under.x1) return true;
    const auto [from, to] = shared_x(part, under);
    const Fine at = foot == Foot::centre ? box.middle() : part.top.at(from) < part.top.at(to) ? from : to;
    const Fine y = part.top.at(at);
    const bool is_near = y >= box.y1 - up && y <= box.y1 + down;
    if (is_near && !part.top.is_steeper_than(tuning_.exact.steepest, at) && (!best || y < *best)) best = y;
    return true;
  });
  return best;
}

std::optional<double> Judge::standing_place(const Rect& box, Foot foot, double rise, double drop) const {
  const auto floor = floor_near(fine_box(box), foot, fine(rise), fine(drop));
  if (!floor) return std::nullopt;
  Rect there = box;
  there.y = px_of(*floor) - box.h;
  if (!is_free(there, foot, Corners::in_its_floor, kSlack)) return std::nullopt;
  return there.y;
}

bool Judge::is_on_floor(const Body& body) const {
  FineBox box = fine_box(body.box);
  // A corner that touches a steep side touches the ground behind it, too.
  const Fine touching = std::min(weld_, (box.x1 - box.x0) / 4);
  box.x0 += touching;
  box.x1 -= touching;
  const auto floor = floor_near(box, body.foot, weld_, weld_);
  if (!floor) return false;
  // Where two steep slopes meet just on a floor, that is in the ground on both sides.
  const Fine y = *floor - scaled(kAhead, tuning_.exact.steepest) - weld_;
  return !ground_.is_solid_at(box.middle() - kAhead, y) || !ground_.is_solid_at(box.middle() + kAhead, y);
}

FineBox Judge::inside_of(const Body& body) const {
  return foot_of(fine_box(body.box).shrunk(slack_), body.foot);
}

bool Judge::is_across_line(const Body& body) const {
  const FineBox inner = inside_of(body);
  return !ground_.for_parts(
      inner, [&](const RawPart& part) { return part.kind != RawPart::Kind::floor || !part.meets(inner); });
}

// Whether a floor, level or steep, is above the bottom of a box, by as much as a body can rise on a way of
// this length.
bool Judge::has_floor_above(const FineBox& box, Foot foot, Fine way) const {
  const FineBox under = foot_of(box, foot);
  const Fine highest = box.y1 - scaled(way, 2 * tuning_.exact.steepest), lowest = box.y1 - weld_;
  return has_floor_in({under.x0, highest, under.x1, lowest});
}

// Whether a floor, level or steep, has its highest point between the sides of an area in the area.
bool Judge::has_floor_in(const FineBox& area) const {
  return !ground_.for_parts(area, [&](const RawPart& part) {
    const auto [from, to] = shared_x(part, area);
    const Fine y = part.top.highest(from, to);
    return !(part.is_floor() && y >= area.y0 && y <= area.y1);
  });
}

// Whether the floor on which the body stood leads on, without an edge, to where it is after the step.
bool Judge::floor_goes_on(const Body& before, const Body& after, int direction) const {
  const FineBox from = fine_box(before.box), to = fine_box(after.box);
  // At the very end of a floor a corner is off it.
  const Fine on = direction * 4 * slack_;
  const auto leads = [&](Fine x, Fine at) {
    const Fine goal = at + on;
    const FloorLine line(ground_, x, from.y1, std::min(x, goal), std::max(x, goal), tuning_.exact.steepest,
                         weld_);
    if (!line.reaches(x, goal)) return false;
    const Fine y = line.at_end(direction, to.y1);
    if (ground_.is_solid_at(goal, y - 2 * weld_)) return false;  // it goes on below a wall
    const FineBox there = to.moved(0, y - to.y1);
    return !has_floor_above(there, after.foot, kFinePx + std::abs(to.x0 - from.x0));
  };
  // A body that just touches two ends, and has not moved, is on no floor.
  if (before.box.x == after.box.x && !has_floor_at_foot(after, Under::middle_of_slopes)) return false;
  if (before.foot == Foot::centre)
    return leads(from.middle(), to.middle()) && !was_on_end_behind(from.middle(), to, direction);
  return leads(from.x0, to.x0) || leads(from.x1, to.x1);
}

// Whether the flat bottom of a body stood on the end of a floor that is behind the x of its middle, and so
// left the floor on which its middle was.
bool Judge::was_on_end_behind(Fine middle, const FineBox& box, int direction) const {
  const FineBox behind = direction > 0 ? FineBox{box.x0 - slack_, box.y1 - weld_, middle, box.y1 + weld_}
                                       : FineBox{middle, box.y1 - weld_, box.x1 + slack_, box.y1 + weld_};
  return !ground_.for_parts(behind, [&](const RawPart& part) {
    const Fine x = direction > 0 ? part.top.x1 : part.top.x0, y = direction > 0 ? part.top.y1 : part.top.y0;
    return !(part.is_floor() && x >= behind.x0 && x <= behind.x1 && y >= behind.y0 && y <= behind.y1);
  });
}

bool Judge::has_floor_at_foot(const Body& body, Under under) const {
  const FineBox box = fine_box(body.box), middle = box.middle_line();
  const bool by_middle = under == Under::middle_of_slopes && body.foot == Foot::centre;
  const FineBox around{box.x0 - weld_, box.y1 - weld_, box.x1 + weld_, box.y1 + weld_};
  return !ground_.for_parts(around, [&](const RawPart& part) {
    if (!part.is_floor()) return true;
    const bool is_at_middle = by_middle && part.top.y0 != part.top.y1;
    const FineBox& foot = is_at_middle ? middle : box;
    // What rolls beside a wall touches ground that is under another part of the wall. What walks goes over
    // gaps.
    const Fine least = under == Under::corners ? -weld_ : is_at_middle ? 0 : slack_;
    if (part.top.x1 - foot.x0 < least || foot.x1 - part.top.x0 < least) return true;
    const auto [from, to] = shared_x(part, foot);
    return !(part.top.highest(from, to) <= box.y1 + weld_ && part.top.lowest(from, to) >= box.y1 - weld_);
  });
}

// A body that rolls on a floor, and is stopped by a low edge.
std::optional<Verdict> Judge::lip_met(const Body& before, const ContactRecord& contact) const {
  Body body = before;
  if (!has_floor_at_foot(body, Under::middle_of_slopes)) return std::nullopt;
  body.box.x = contact.touch.x;
  body.box.y = contact.touch.y;
  const int direction = contact.normal.x > 0 ? -1 : 1;
  if (contact.normal.y != 0) {
    // A body that slides down a steep slope is not stopped by it.
    return is_on_floor(before) ? judge_stop(body, direction) : std::nullopt;
  }
  const Ahead ahead = ahead_of(body, direction);
  // A body that falls past the end of a floor has just touched it, and is hardly lower.
  if (ahead.way != Way::lip || ahead.edge.height <= weld_ + kEndSlacks * slack_) return std::nullopt;
  Edge edge = ahead.edge;
  // One that bounces is above its floor.
  const FineBox box = fine_box(body.box);
  if (const auto floor = floor_near(box, body.foot, 0, lip_)) edge.height += *floor - box.y1;
  return edge.height > lip_ + slack_ ? std::nullopt : std::optional(lip_of(direction, edge));
}

Verdict Judge::lip_of(int direction, const Edge& edge) const {
  return {FindingKind::lip, rounded_px(px_of(edge.height)), Vec2{px_of(edge.x), rounded_px(px_of(edge.top))},
          direction};
}

// The middle of the body was above a floor, and is below it. A box that was in the floor already does not
// count.
bool Judge::falls_through(const Body& before, const Body& after) const {
  const FineBox from = fine_box(before.box), to = fine_box(after.box);
  if (to.y1 <= from.y1 + weld_) return false;
  const Fine left = std::min(from.middle(), to.middle()), right = std::max(from.middle(), to.middle());
  return !ground_.for_parts({left, from.y1 - slack_, right, to.y1}, [&](const RawPart& part) {
    if (!part.is_floor() || part.top.x0 + slack_ > left || part.top.x1 - slack_ < right) return true;
    const Fine through = part.top.curve != nullptr ? kChord : weld_;
    return !(part.top.at(from.middle()) >= from.y1 - slack_ && part.top.at(to.middle()) < to.y1 - through);
  });
}

// Whether anything stops a body that goes from one place to another one close by. floor: the y of the floor
// below its middle there.
bool Judge::passes(const FineBox& from, const FineBox& to, Foot foot, Fine floor) const {
  const FineBox inner = from.shrunk(slack_), goal = to.shrunk(slack_);
  std::optional<FloorLine> line;
  return ground_.for_parts(hull(inner, goal), [&](const RawPart& part) {
    // Only the middle of a body on its centre meets a sloped line that it may stand on.
    if (foot == Foot::centre && part.kind == RawPart::Kind::floor && part.is_sloped())
      return !part.stops(inner.middle_line(), goal.middle_line()) && !ends_under(part.top, inner, goal);
    if (foot == Foot::centre && part.stops(inner.middle_line(), goal.middle_line())) return false;
    if (!part.stops(inner, goal)) return true;
    if (foot == Foot::box) return false;
    if (!line) line = floor_line(to, floor, least_weld_);
    const auto [x0, x1] = shared_x(part, to);
    return line->covers(part, x0, x1);
  });
}

// Whether a line, from which no floor goes on there, ends under the flat bottom of a body that stands on its
// centre, and so keeps it from going down.
bool Judge::ends_under(const RawLine& line, const FineBox& from, const FineBox& to) const {
  const auto ends_at = [&](Fine x, Fine y, int direction) {
    const bool is_beside = direction > 0 ? x > to.middle() && x < to.x1 : x > to.x0 && x < to.middle();
    return is_beside && from.y1 <= y && to.y1 > y && !has_floor_to(x, y, direction);
  };
  return ends_at(line.x0, line.y0, 1) || ends_at(line.x1, line.y1, -1);
}

// Along a curve a body stops a little before it has no room, and a little beside the curve, as a step goes
// along its chord.
Judge::Ahead Judge::ahead_of(const Body& body, int direction) const {
  const Ahead ahead = ahead_of(body, direction, ahead_);
  // A corner of the ground may be in the way between the two places.
  for (Fine way = ahead_ / 2; ahead.way == Way::free && way >= slack_; way /= 2) {
    const Ahead nearer = ahead_of(body, direction, way);
    if (nearer.way == Way::blocked) return nearer;
  }
  const FineBox box = fine_box(body.box);
  if (ahead.way != Way::free || !ground_.has_curve_in(box)) return ahead;
  Body there = body;
  if (const auto floor = floor_near(box, body.foot, kChord, kChord)) {
    // On the chord it has just the room that it has not on its curve.
    if (*floor < box.y1 && !passes(box, box.moved(0, *floor - box.y1), body.foot)) return {Way::blocked};
    there.box.y += px_of(*floor - box.y1);
  }
  return ahead_of(there, direction, kAheadOnCurve);
}

Judge::Ahead Judge::ahead_of(const Body& body, int direction, Fine way) const {
  const FineBox box = fine_box(body.box), next = box.moved(direction * way, 0);
  if (passes(box, next, body.foot)) return {Way::free};
  const double steepest = tuning_.exact.steepest;
  const auto edge = edge_at(box, body.foot, direction, 4 * slack_);
  const Fine rounding = scaled(4 * slack_, steepest) + slack_;
  if (edge && edge->height > rounding)
    return edge->height > lip_ + rounding ? Ahead{Way::blocked} : Ahead{Way::lip, *edge};
  const Fine slope = scaled(way, steepest) + slack_;
  const auto floor = floor_near(next, body.foot, slope, slope);
  if (floor && passes(box, next.moved(0, *floor - box.y1), body.foot)) return {Way::free};
  const auto rise = edge_at(box, body.foot, direction, way);
  return {rise && rise->height <= slope ? Way::free : Way::blocked};
}

// The edge at the top of what is ahead, and too steep to walk on: a wall, or a bevel.
std::optional<Judge::Edge> Judge::bevel_at(const FineBox& box, Foot foot, int direction) const {
  const auto walked = [&](Fine way) { return scaled(way, tuning_.exact.steepest) + slack_; };
  std::optional<Edge> edge = edge_at(box, foot, direction, 4 * slack_), beyond;
  for (Fine way = 4 * slack_; edge && way < kMaxBevel; way *= 2, edge = beyond) {
    beyond = edge_at(box, foot, direction, 2 * way);
    if (!beyond || edge->height <= walked(way) || beyond->height - edge->height > walked(way)) continue;
    edge = beyond;
    // Where it is no longer too steep.
    constexpr Fine kStep = kAhead / 8;
    Fine before = 4 * slack_, after = 2 * way;
    while (after - before > kStep) {
      const Fine middle = (before + after) / 2;
      const auto here = edge_at(box, foot, direction, middle);
      const auto ahead = edge_at(box, foot, direction, middle + kStep);
      if (!here || !ahead) break;
      const bool is_past = ahead->height - here->height <= walked(kStep);
      (is_past ? after : before) = middle;
      if (is_past) edge = here;
    }
    edge->x += direction * after;
    return edge;
  }
  return std::nullopt;
}

// The edge onto which a body must be lifted from its floor to go on by that way.
std::optional<Judge::Edge> Judge::edge_at(const FineBox& box, Foot foot, int direction, Fine way) const {
  const FineBox next = box.moved(direction * way, 0);
  const auto rise = rise_onto(box, next, foot);
  if (!rise) return std::nullopt;
  const Fine top = box.y1 - *rise, middle = box.middle(), front = direction > 0 ? box.x1 : box.x0;
  if (foot == Foot::box || *rise == 0) return Edge{*rise, front, top};
  // Corners beside the middle may be in the floor, and an edge begins where that ends, or above it.
  const FloorLine line(ground_, middle, box.y1, std::min(middle, front), std::max(middle, front),
                       tuning_.exact.steepest, least_weld_);
  if (!line.reaches(middle, next.middle()) ||
      stops_middle(box, next.moved(0, line.at(next.middle()) - box.y1)))
    return Edge{*rise, middle, top};
  const Fine above = *rise - (box.y1 - line.at_end(direction, box.y1));
  return Edge{above > weld_ || line.reaches(middle, front) ? above : *rise, front, top};
}

// How far a body must be lifted to go on to a place, at most as far as an edge and a floor may rise.
std::optional<Fine> Judge::rise_onto(const FineBox& from, FineBox to, Foot foot) const {
  const Fine in_floor = foot == Foot::centre ? scaled((to.x1 - to.x0) / 2, tuning_.exact.steepest) : 0;
  const Fine most = std::max(lip_, scaled(kAheadOnCurve, 2 * tuning_.exact.steepest)) + in_floor + weld_;
  const bool is_above_floor = passes(from, from, Foot::box);
  const Fine start = to.y1;
  for (int i = 0; i < kMaxRises; ++i) {
    // A body that is lifted by more than its height must not pass a ceiling in between. Where a corner is in
    // the floor, what is beside that counts, too.
    const FineBox between{from.x0, to.y1, from.x1, from.y0};
    const bool has_room = !is_above_floor || between.y0 >= between.y1 || passes(between, between, foot);
    const FineBox lifted{to.x0, to.y0, to.x1, is_above_floor ? to.y1 : std::max(to.y1, from.y0 + 2 * slack_)};
    if (has_room && passes(from, lifted, foot)) return start - to.y1;
    Fine top = to.y1;
    ground_.for_parts(to, [&](const RawPart& part) {
      const bool is_wall = part.top.x0 == part.top.x1;
      if (!part.is_floor() && !is_wall) return true;
      if (!part.stops(from.shrunk(slack_), to.shrunk(slack_))) return true;
      const auto [x0, x1] = shared_x(part, to);
      top = std::min(top, is_wall ? std::min(part.top.y0, part.top.y1) : part.top.highest(x0, x1));
      return true;
    });
    if (top == to.y1 || start - top > most) return std::nullopt;
    to = to.moved(0, top - to.y1);
  }
  return std::nullopt;
}

// Whether anything stops a box, or its middle, that goes from one place to another one close by.
bool Judge::stops_at(const FineBox& from, const FineBox& to) const {
  const FineBox inner = from.shrunk(slack_), goal = to.shrunk(slack_);
  return stops_middle(from, to) ||
         !ground_.for_parts(hull(inner, goal), [&](const RawPart& part) { return !part.stops(inner, goal); });
}

bool Judge::stops_middle(const FineBox& from, const FineBox& to) const {
  const FineBox inner = from.shrunk(slack_).middle_line(), goal = to.shrunk(slack_).middle_line();
  return !ground_.for_parts(hull(inner, goal), [&](const RawPart& part) { return !part.stops(inner, goal); });
}

// Whether the bottom (or top) of a box is on an end of a sloped floor (or ceiling). A body on its centre may
// be on an end of a level one, too. only_upright: of a curve that is upright there.
bool Judge::is_on_end(const FineBox& box, Foot foot, bool bottom, bool only_upright) const {
  const Fine at = bottom ? box.y1 : box.y0;
  const auto is_on = [&](Fine x, Fine y) {
    return x >= box.x0 - slack_ && x <= box.x1 + slack_ && std::abs(y - at) <= weld_;
  };
  const FineBox side{box.x0 - slack_, at - weld_, box.x1 + slack_, at + weld_};
  return !ground_.for_parts(side, [&](const RawPart& part) {
    const bool faces =
        bottom ? part.is_floor() : part.kind == RawPart::Kind::solid || part.kind == RawPart::Kind::ceiling;
    if (!faces || (part.kind == RawPart::Kind::solid && !part.is_sloped() && foot == Foot::box)) return true;
    const RawLine& line = bottom ? part.top : part.bottom;
    const auto is_end = [&](Fine x, Fine y) {
      return is_on(x, y) && (!only_upright || line.is_upright_curve(x));
    };
    return !is_end(line.x0, line.y0) && !is_end(line.x1, line.y1);
  });
}

// Behind what a body meets there is ground. A body that meets a corner exactly finds it a little to the side
// to which it moves, or from which it came.
bool Judge::is_there(const ContactRecord& contact, const Body& body) const {
  const FineBox box = fine_box({contact.touch.x, contact.touch.y, body.box.w, body.box.h});
  const Vec2 n = contact.normal;
  // Less than the body's own size, so that it does not pass a line. It may pass the end of a steep one, so
  // less is tried, too.
  const Fine ahead = std::min(kAhead, std::min(box.x1 - box.x0, box.y1 - box.y0) / 2);
  const FineBox into = box.moved(scaled(ahead, -n.x), scaled(ahead, -n.y));
  const bool is_sloped = n.x != 0 && n.y != 0;
  if (is_sloped && stops_at(box, box.moved(0, n.y < 0 ? ahead : -ahead))) return true;
  if (is_on_end(box, body.foot, n.y <= 0, n.y == 0)) return true;
  // What it touches by rounding is before it.
  const FineBox before = box.moved(scaled(slack_, n.x), scaled(slack_, n.y));
  for (Fine way = ahead; way > slack_; way /= 4)
    if (stops_at(before, box.moved(scaled(way, -n.x), scaled(way, -n.y)))) return true;
  const Vec2 side = contact.move - n * dot(contact.move, n);
  const double length = std::sqrt(dot(side, side));
  if (!(length > 0)) return false;
  const Fine x = scaled(4 * slack_, side.x / length), y = scaled(4 * slack_, side.y / length);
  if (stops_at(box, into.moved(-x, -y))) return true;
  // Unless a wall goes on beside the corner.
  FineBox strip = box;
  if (n.y != 0) (n.y < 0 ? strip.y0 : strip.y1) = n.y < 0 ? box.y1 - ahead : box.y0 + ahead;
  if (n.x != 0) (n.x < 0 ? strip.x0 : strip.x1) = n.x < 0 ? box.x1 - ahead : box.x0 + ahead;
  return stops_at(box, into.moved(x, y)) && !stops_at(strip, strip.moved(x, y));
}

}  // namespace talus
