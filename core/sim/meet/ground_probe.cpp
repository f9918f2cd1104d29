#include "ground_probe.h"

#include <algorithm>
#include <cmath>

#include "../../collision/box_on_piece.h"
#include "../flight.h"
#include "contact_set.h"

namespace talus {
namespace {

double longest(Vec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); }

// When a path meets the surface of a contact, at most `most` frames on, and the normal there.
Arrival<double> arrival(const Terrain& ground, const MovingBox& box, const Contact<double>& contact,
                        double most) {
  const FallPath& path = box.path;
  const Rect from = box.at(path.time);
  const double slack = touch_slack(from, from);
  const auto time_to = [&](Vec2 point, Vec2 normal) {
    const double gap = std::max(0.0, dot(path.place - point, normal));
    const double speed = -dot(path.velocity, normal), gain = -dot(path.pull, normal);
    // A box at rest above rounding would fall for much longer than rounding.
    if (gap <= slack && std::abs(speed) <= kStillOnGround && gain > kStillOnGround) return 0.0;
    const double time = time_to_close(gap, speed, gain);
    return time < most ? time : most * contact.t;
  };
  const Rect there{contact.position.x, contact.position.y, box.size.x, box.size.y};
  return arrival_on(contact, ground.stretches(), there, Foot::box, time_to,
                    [&](double time) { return path.place_at(path.time + time).x; });
}

// Whether a way along what a box touches is so short that rounding alone would lead it into that: such boxes
// would meet it again and again.
bool is_rounding(const MovingBox& box, Vec2 way, Vec2 normal) {
  const FallPath& path = box.path;
  if (-dot(path.velocity, normal) > kStillOnGround || -dot(path.pull, normal) > kStillOnGround) return false;
  const Rect from = box.at(path.time);
  return longest(way) <= touch_slack(from, from);
}

bool is_same_line(const Contact<double>& a, const Contact<double>& b) {
  const Piece<double>*const p = a.piece, *const q = b.piece;
  if (p == nullptr || q == nullptr || a.on_end || b.on_end || p->stretch != 0) return false;
  return p->x0 == q->x0 && p->y0 == q->y0 && p->x1 == q->x1 && p->y1 == q->y1;
}

// Puts a box exactly on what it has met.
void put_on(const Terrain& ground, const Contact<double>& contact, Rect& box) {
  if (contact.normal.x == 0 || contact.on_end) {
    box.y = contact.position.y;
  } else if (contact.normal.y == 0) {
    box.x = contact.position.x;
  } else if (!is_steep(*contact.piece)) {
    const double x = box.x + foot_offset(*contact.piece, box.w, Foot::box);
    if (x >= contact.piece->x0 && x <= contact.piece->x1)
      box.y = rest_on(*contact.piece, ground.stretches(), box, Foot::box);
  }
}

}  // namespace

void GroundProbe::align(const Contact<double>& contact, bool stays, MovingBox& box,
                        CastBudget& budget) const {
  const Vec2 normal = contact.normal;
  FallPath& path = box.path;
  if (contact.piece != nullptr && contact.piece->stretch != 0 && !contact.on_end) return;
  const auto turn = [&](Vec2& way) {
    if (contact.normal.x == 0)
      way.y = 0;
    else if (contact.normal.y == 0)
      way.x = 0;
    else if (is_steep(*contact.piece))
      way.x = way.y / contact.piece->slope;
    else
      way.y = way.x * contact.piece->slope;
  };
  turn(path.velocity);
  if (stays) turn(path.pull);
  Rect there = box.at(path.time);
  put_on(ground_, contact, there);
  const Vec2 way = there.position() - path.place;
  if (way == Vec2()) return;
  // On its way down to one side of a valley it may touch the other one.
  if (!(dot(way, normal) > 0)) {
    const Contact<double> met =
        cast_box<double>(ground_, {box.at(path.time), way, Foot::box}, {}, nullptr, &budget);
    if (met) return void(path.place = met.position);
  }
  path.place = there.position();
}

// The same where it is. along: as for next_meeting().
std::optional<Contact<double>> GroundProbe::touched_there(const Rect& box, Vec2 way,
                                                          const Piece<double>* along,
                                                          CastBudget& budget) const {
  const Vec2 step = way * (1 / longest(way));
  const Contact<double> contact = cast_box<double>(ground_, {box, step, Foot::box}, {}, along, &budget);
  if (!contact || -dot(contact.normal, step) * contact.t > touch_slack(box, box)) return std::nullopt;
  return contact;
}

std::optional<Contact<double>> GroundProbe::touched(Rect& box, Vec2 way, CastBudget& budget) const {
  for (int lifts = 0; lifts < 2; ++lifts) {
    const auto contact = touched_there(box, way, nullptr, budget);
    if (!contact) return std::nullopt;
    Moving<double> there{box, {}, Foot::box};
    if (!climbs<double>(ground_, {}, there, *contact, &budget)) return contact;
    box = there.box;
  }
  return std::nullopt;
}

bool GroundProbe::moves_off_crest(const Contact<double>& contact, Rect& box, CastBudget& budget) const {
  if (!contact.on_end || contact.facing != Facing::up || contact.normal.x != 0) return false;
  const Piece<double>& piece = *contact.piece;
  const double crest = piece.rises_to_the_right() ? piece.x1 : piece.x0, slack = touch_slack(box, box);
  double off = 0;
  if (std::abs(box.x - crest) <= slack) off = crest + 2 * slack - box.x;
  if (std::abs(box.right() - crest) <= slack) off = crest - 2 * slack - box.right();
  if (off == 0 || cast_box<double>(ground_, {box, {off, 0}, Foot::box}, {}, nullptr, &budget)) return false;
  box.x += off;
  return true;
}

std::optional<GroundMeeting> GroundProbe::next_meeting(const MovingBox& box, double to,
                                                       const Piece<double>* along, CastBudget& budget) const {
  const Rect from = box.at(box.path.time);
  const double slack = touch_slack(from, from), end = to;
  std::optional<GroundMeeting> found;
  const Piece<double>* ignored = along;
  bool is_sure = true;
  // A chord may meet another piece first than the path does: each is cut where the last one led to.
  constexpr int kMaxTries = 8;
  for (int i = 0; i < kMaxTries; ++i) {
    const Vec2 way = box.path.way_to(to);
    if (way == Vec2()) break;
    const Contact<double> contact = cast_box<double>(ground_, {from, way, Foot::box}, {}, ignored, &budget);
    if (!contact || is_rounding(box, way, contact.normal)) break;
    // A path that ends on a line meets it there, wherever rounding lets the chord meet it.
    is_sure = !found;
    if (found && is_same_line(contact, found->contact)) break;
    const Arrival<double> then = arrival(ground_, box, contact, to - box.path.time);
    const double time = box.path.time + then.time;
    if (!(time < to)) break;  // what it comes to at the end of a part belongs to the next one
    Rect there = box.at(time);
    put_on(ground_, contact, there);
    found = GroundMeeting{time, then.normal, there.position(), contact};
    is_sure = longest(there.position() - contact.position) <= slack;
    if (is_sure) break;
    if (along == nullptr && contact.piece != nullptr && contact.piece->stretch == 0 && !contact.on_end)
      ignored = contact.piece;
    to = time;
  }
  // The path may pass the end of what a chord meets. Shorter chords are nearer to the path.
  if (is_sure || !box.path.bends(end, slack)) return found;
  const Rect there{found->place.x, found->place.y, box.size.x, box.size.y};
  if (touched_there(there, found->normal * -1, along, budget)) return found;
  const double middle = (box.path.time + end) / 2;
  if (auto first = next_meeting(box, middle, along, budget)) return first;
  return next_meeting({box.path.from(middle), box.size}, end, along, budget);
}

}  // namespace talus
