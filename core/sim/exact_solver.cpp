#include "exact_solver.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "../collision/ground_queries.h"
#include "body_grid.h"
#include "contact_notes.h"
#include "event_notes.h"
#include "exact_body.h"
#include "floor_walk.h"
#include "meet/meeting.h"
#include "mouse.h"
#include "step_limits.h"

namespace talus {
namespace {

// The ground in the solver's precision.
template <class Real>
const std::shared_ptr<const BasicTerrain<Real>>& ground_of(const Scene& scene) {
  if constexpr (std::is_same_v<Real, float>) {
    return scene.single_ground;
  } else {
    return scene.ground;
  }
}

// A body in the air passes the side of a tile to which a floor leads up from below its middle, if that is at
// most so many of its widths lower: those of a slope of 16 to 1.
constexpr int kDeepestFloor = 8;

template <class Real>
class ExactSolver final : public Solver {
 public:
  explicit ExactSolver(std::shared_ptr<const Scene> scene)
      : scene_(std::move(scene)),
        ground_(*ground_of<Real>(*scene_)),
        numbers_(scene_->tuning),
        kinds_(body_kinds()),
        quiet_fall_(static_cast<Real>(quiet_speed(scene_->tuning, BodyRule::fall))),
        quiet_run_(static_cast<Real>(quiet_speed(scene_->tuning, BodyRule::run))),
        pairs_(scene_->features.pairs),
        max_passes_(static_cast<int>(scene_->tuning.exact.max_passes)),
        substeps_(static_cast<int>(scene_->tuning.exact.substeps)),
        part_(Real(1) / static_cast<Real>(substeps_)) {
    if (scene_->features.meets) meeting_ = std::make_unique<Meeting>(scene_);
  }

  void step(State& state, const Input& input, StepRecord* record) override {
    if (record != nullptr) record->clear();
    events_ = record != nullptr ? &record->events : nullptr;
    record_ = record != nullptr && !record->only_events ? record : nullptr;
    bodies_ = &state.bodies;
    if (pairs_) {
      grid_.synchronise(state.bodies);
    } else {
      rests_.resize(state.bodies.size());
    }
    take_mouse(state, input, [&] { return body_at(state, input.mouse); });
    step_budget_ = StepBudget(state.bodies.size());
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      if (meeting_ && meeting_->moves(state.bodies[i], state)) [[unlikely]]
        note_start(state.bodies[i]);
      else
        step_body(state, i, input);
    }
    if (meeting_) {  // after the players
      step_budget_.spend(meeting_->step(state, input, record_, events_));
      if (record_ != nullptr) sort_by_body(record_->contacts);
    }
    if (record_ != nullptr) record_->work = step_budget_.spent();
    ++state.frame;
  }

 private:
  using Vec = BasicVec2<Real>;

  static Vec narrow(Vec2 v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y)}; }
  static BasicRect<Real> narrow(const Rect& r) {
    return {static_cast<Real>(r.x), static_cast<Real>(r.y), static_cast<Real>(r.w), static_cast<Real>(r.h)};
  }
  static Vec2 widen(Vec v) { return {v.x, v.y}; }
  static Rect widen(const BasicRect<Real>& r) { return {r.x, r.y, r.w, r.h}; }

  void step_body(State& state, std::size_t index, const Input& input) {
    Body& body = state.bodies[index];
    Moving<Real> moving{narrow(body.box), narrow(body.velocity), body.foot};
    note_start(body);
    const std::int64_t part = step_budget_.part();
    budget_ = {part};
    if (!body.is_clear) leave_ground(moving);
    order_ = 0;
    const bool stood = body.gait.grounded;

    if (body.id == state.grabbed) {
      drag(state, index, moving, input);
    } else {
      switch (kinds_[static_cast<std::size_t>(body.kind)].rule) {
        case BodyRule::fall:
          if (numbers_.flies)
            fall<true>(state, index, moving);
          else
            fall<false>(state, index, moving);
          break;
        case BodyRule::run:
          run(state, index, moving, input);
          break;
      }
    }

    limit(moving);
    const Rect before = body.box;
    body.box = widen(moving.box);
    body.velocity = widen(moving.velocity);
    body.is_clear = true;
    note_standing(events_, body, stood);
    step_budget_.spend(part - budget_.left);
    if (pairs_ && !(before == body.box))
      step_budget_.spend(grid_.place(static_cast<std::uint32_t>(index), body.box));
    if (record_ != nullptr) record_->paths.back().to = body.box;
  }

  // ---- Balls ----

  template <bool flies>
  void fall(State& state, std::size_t index, Moving<Real>& moving) {
    Body& body = state.bodies[index];
    BallRule<Real, flies> rule(numbers_, ground_, budget_, moving);
    rule.pull(part_);
    for (int i = 0; i < substeps_; ++i) {
      rule.begin();
      if (i == 0) note_goal(moving, moving.velocity);
      const auto respond = [&](const auto& contact, Vec motion) {
        const Vec rest = rule.respond(contact, motion);
        note_change(body, contact, rule.change(), quiet_fall_);
        return rest;
      };
      move(state, index, moving, moving.velocity * part_, respond,
           [&](Contact<Real>& contact) { return rule.aim(contact, others_); });
    }
    rule.end();
    body.gait.grounded = rule.grounded();
  }

  // A dragged ball goes part of the way to the mouse, and slides along what it meets.
  void drag(State& state, std::size_t index, Moving<Real>& moving, const Input& input) {
    Body& body = state.bodies[index];
    body.previous = body.box.position();
    const Vec2 goal = drag_goal(scene_->tuning.shared, body, input);
    const Vec way = narrow(within_limits(body.previous, goal) - body.previous);
    note_goal(moving, way);
    move(state, index, moving, way, slide, is_as_met);
  }

  // ---- Players ----

  void run(State& state, std::size_t index, Moving<Real>& moving, const Input& input) {
    Gait& gait = state.bodies[index].gait;
    PlayerRule<Real> rule(numbers_, moving, gait);
    rule.take(input, gait.grounded && ground_.has_conveyors() ? conveyor_under(state, index, moving) : 0);
    if (gait.coyote > 0) --gait.coyote;
    const Real x = moving.box.x;
    const bool walked = gait.grounded;
    Vec motion = walked ? Vec{moving.velocity.x, 0} : moving.velocity;
    note_goal(moving, motion);
    if (walked && walk(state, index, moving, rule, motion)) return rule.stand();
    const auto respond = [&](const auto& contact, Vec m) {
      const Vec velocity = moving.velocity, rest = rule.respond(contact, m);
      note_change(state.bodies[index], contact, dot(moving.velocity - velocity, contact.normal), quiet_run_);
      return rest;
    };
    const bool held = move(state, index, moving, motion, respond, is_as_met);
    if (held && motion.y > 0) return rule.stand();
    if (rule.landed()) rule.stand();
    if (!gait.grounded) return;

    const auto floor = floor_under(state, index, moving, rule.reach_down(moving.box.x - x));
    if (floor) {
      moving.box.y = floor.position.y;
      rule.stand();
    } else if (walked && stands_between(state, index, moving)) {
      rule.stand();
    } else if (walked) {
      rule.leave_ground();
    } else {
      gait.grounded = false;
    }
  }

  // Takes a body along the floor that it stands on. Returns true if it is on a floor afterwards. Otherwise
  // the floor has ended, and `motion` becomes the rest of the body's way.
  bool walk(const State& state, std::size_t index, Moving<Real>& moving, PlayerRule<Real>& rule,
            Vec& motion) {
    const Real speed = moving.velocity.x, reach = rule.reach_down(0);
    if (speed == 0) return false;
    if (!gather(state, index, moving, {speed, std::abs(speed) * numbers_.steepest + reach + 1})) {
      note_cut_short();
      return true;
    }
    FloorWalk<Real> way(ground_, others_, speed < 0 ? -1 : 1, numbers_.steepest, &budget_);
    std::optional<FloorAhead<Real>> floor;
    Real rest = 1;        // of the step
    Real part = 1;        // of the rest, that is taken in one go along a curve
    bool at_end = false;  // of a piece, where the next one begins
    for (int contacts = 0; contacts < max_passes_;) {
      if (!floor) floor = way.floor_ahead(moving, reach);
      if (budget_.left <= 0) {
        note_cut_short();
        return true;
      }
      if (!floor) {
        motion = motion * rest;
        return false;
      }
      const Vec before = motion;
      motion = rule.walk(floor->contact.normal);
      if (rest == 1) note_goal(moving, motion);
      if (at_end) note_turn(state.bodies[index], moving, floor->contact, before * rest);
      if (at_end || contacts > 0) note_after(motion * rest);
      Vec goal = way.goal_before_line(*floor, moving,
                                      way.goal_on(*floor, moving.box, motion.x * rest * part, moving.foot));
      if (goal.x == moving.box.x) return true;
      const auto contact = way.cast_to(*floor, moving, goal);
      if (!contact && budget_.seen < 1) {
        note_cut_short();
        return true;
      }
      if (contact && record_ != nullptr) note(state.bodies[index], contact, goal - moving.box.position());
      const auto past = way.place_past(contact, moving.box, goal, moving.foot);
      // What it has just come to does not stop it if the next piece leads past it.
      const bool arrives = past ? *past == goal : contact && way.arrives(contact, moving, goal);
      const Vec at = past ? *past : contact && !arrives ? contact.position : goal;
      const Real from = moving.box.x;
      rest -= (at.x - moving.box.x) / motion.x;
      moving = moved_to(moving, at);
      at_end = !contact || arrives;
      if (arrives) note_after(motion * std::max<Real>(rest, 0));
      if (at_end) {
        at_end = goal.x == floor->end;
        if (contact && way.is_behind(contact, moving)) moving = moved_to(moving, contact.position);
        if (!(rest > 0) || (!at_end && part == 1)) return true;
        if (at_end) floor.reset();
        part = 1;
        continue;
      }
      if (past) {
        ++contacts;
        note_after(motion * rest);
        continue;
      }
      note_after({});
      const auto after = passes(way, floor, moving, reach, from, goal, contact);
      if (after == AfterContact::shortens) {  // what it has met does not stop it, and does not count
        part /= 2;
        note_after(motion * rest);
        continue;
      }
      ++contacts;
      if (after == AfterContact::leaves) {
        motion = {motion.x * rest, 0};
        return false;
      }
      if (after == AfterContact::stops) {
        const Vec velocity = moving.velocity;
        rule.stop_at(contact);
        const Real change = dot(moving.velocity - velocity, contact.normal);
        note_change(state.bodies[index], contact, change, quiet_run_);
        return true;
      }
    }
    if (record_ != nullptr) record_->paths.back().capped = true;
    return true;
  }

  // What a walking body does that has met something.
  enum class AfterContact : std::uint8_t {
    goes_on,
    shortens,  // goes on along its curve, of which it takes half of that part in one go
    leaves,    // the floor has ended
    stops
  };

  // What a walking body does that went from x to a goal and met something. If it goes on, `floor` is the one
  // that it goes on along, or nothing if it has to look for it. reach: as for FloorWalk::floor_ahead().
  AfterContact passes(FloorWalk<Real>& way, std::optional<FloorAhead<Real>>& floor, Moving<Real>& moving,
                      Real reach, Real from, Vec goal, const Contact<Real>& contact) {
    const Real y = moving.box.y;
    way.lift_onto(*floor, moving);
    if (way.sinks(moving, contact, goal.y) || climbs<Real>(ground_, others_, moving, contact, &budget_)) {
      floor.reset();
      return AfterContact::goes_on;
    }
    moving.box.y = y;
    if (contact.normal.y <= 0 && way.leads_above(*floor, moving, contact, from, goal.x)) {
      way.lift_onto(*floor, moving);
      return AfterContact::shortens;
    }
    if (contact.normal.y < 0 && is_level(contact, numbers_.steepest)) {
      way.lift_onto(*floor, moving);  // its own curve may cross what it has met once more
      floor = way.floor_met(moving, contact);
      return AfterContact::goes_on;
    }
    const bool is_at_floor = way.is_straight(*floor) || contact.t == 0;
    if (!is_at_floor) way.stop_on(*floor, moving, from, contact);
    const bool joins = is_at_floor && way.joins(*floor, moving);
    if (const auto to_joint = way.floor_to_joint(*floor, moving, contact)) {
      floor = to_joint;
      return AfterContact::goes_on;
    }
    if (joins) return AfterContact::goes_on;
    // From the foot of a low side, the floor ahead is the one that begins at its top.
    if (is_at_floor && contact.normal.y == 0 && contact.t > 0) {
      Moving<Real> there = moving;
      const auto next = way.floor_ahead(there, reach);
      if (next && way.joins(*next, there)) {
        floor = next;
        moving = there;
        return AfterContact::goes_on;
      }
    }
    if (contact.normal.y < 0 && contact.normal.x * moving.velocity.x > 0) return AfterContact::leaves;
    // It may pass the last corner of a ceiling, or go on along a curve that is not where its chord is.
    const bool has_room = way.is_straight(*floor)
                              ? contact.facing == Facing::down
                              : way.room_at(moving.box.position(), contact) > Real(kFloorStep);
    return has_room && contact.t > 0 ? AfterContact::goes_on : AfterContact::stops;
  }

  // The level ground straight below, within `reach`, or at the foot of something too steep.
  Contact<Real> floor_under(const State& state, std::size_t index, const Moving<Real>& moving, Real reach) {
    if (budget_.left <= 0 || !gather(state, index, moving, {0, reach})) {
      note_cut_short();
      return {};
    }
    const Cast<Real> down{moving.box, {0, reach}, moving.foot};
    const Contact<Real> met = cast_box<Real>(ground_, down, others_, nullptr, &budget_);
    if (!met || is_level(met, numbers_.steepest)) return met;
    Contact<Real> floor = cast_box<Real>(ground_, down, others_, met.piece, &budget_);
    if (floor && !is_level(floor, numbers_.steepest))  // the same side once more, or another one behind it
      floor = cast_box<Real>(ground_, down, others_, {met.piece, std::array{floor.piece}}, &budget_);
    const bool is_foot =
        floor && is_level(floor, numbers_.steepest) && floor.position.y - met.position.y <= Real(kMaxLip);
    if (!is_foot) return {};
    floor.position.y = met.position.y;
    return floor;
  }

  // px/frame: how fast the floor that a body stands on carries it, as its velocity along x is measured.
  Real conveyor_under(const State& state, std::size_t index, const Moving<Real>& moving) {
    const Contact<Real> floor = floor_under(state, index, moving, Real(kMaxLip));
    if (!floor || floor.is_other) return 0;
    const auto speed = static_cast<Real>(conveyor_at(ground_, floor, moving.box));
    return numbers_.surface_speed ? speed : speed * -floor.normal.y;
  }

  // Whether a body lies on two sides that are too steep to stand on, but hold it up together. Puts it on
  // them.
  bool stands_between(const State& state, std::size_t index, Moving<Real>& moving) {
    const Vec down{0, Real(kMaxLip)};
    if (budget_.left <= 0 || !gather(state, index, moving, down)) return false;
    Moving<Real> there = moving;
    Mover<Real> mover(ground_, others_, max_passes_, nullptr, &budget_);
    if (!mover.move(there, down, slide, [](const Contact<Real>&, Vec) { return true; }).held) return false;
    moving = moved_to(moving, there.box.position());
    return true;
  }

  // ---- All ----

  // The rest of a motion goes on along what it met.
  static Vec slide(const Contact<Real>& contact, Vec motion) {
    return slide_along(contact.normal, motion * (1 - contact.t));
  }

  static bool is_as_met(Contact<Real>&) { return true; }

  // aim(contact): may change a contact before the body responds to it; false: it meets nothing. Returns
  // whether two sides that it met hold it up.
  template <class Respond, class Aim>
  bool move(const State& state, std::size_t index, Moving<Real>& moving, Vec motion, Respond respond,
            Aim aim) {
    if (!gather(state, index, moving, motion)) {
      note_cut_short();
      return false;
    }
    Mover<Real> mover(ground_, others_, max_passes_, pairs_ ? nullptr : &rests_[index], &budget_);
    const auto answer = [&](const Contact<Real>& contact, Vec way) {
      const Vec after = respond(contact, way);
      note_after(after);
      return after;
    };
    const auto seen = [&](Contact<Real>& contact, Vec way) {
      if (!aim(contact)) return false;
      if (record_ != nullptr) note(state.bodies[index], contact, way);
      return true;
    };
    const auto sinks = [&](const Contact<Real>& contact, Vec way, Real sunk) {
      return depth_below_floor(moving, contact, way.y, sunk);
    };
    const auto result = mover.move(moving, motion, answer, seen, sinks);
    if (record_ == nullptr) return result.held;
    if (result.wedged) note_after({});
    if (result.cut_short) note_cut_short();
    record_->paths.back().capped = record_->paths.back().capped || result.capped;
    return result.held;
  }

  // px, as Cast::sunk: how deep the corners of a body on its centre are to be below the floor, if that leads
  // over the side that a corner has met on its way, which ends y px lower. 0: the side stops it.
  Real depth_below_floor(const Moving<Real>& moving, const Contact<Real>& contact, Real y, Real sunk) {
    FloorWalk<Real> over(ground_, others_, 1, numbers_.steepest, &budget_, sunk);
    const Moving<Real> there = moved_to(moving, contact.position);
    const Real goal_y = contact.position.y + std::max<Real>(y, 0) * (1 - contact.t);
    return over.sinks(there, contact, goal_y, moving.box.w * kDeepestFloor) ? over.sunk() : 0;
  }

  // Finds the other bodies that the motion may meet, however contacts turn it. Returns false if there are
  // more than the body may test.
  bool gather(const State& state, std::size_t index, const Moving<Real>& moving, Vec motion) {
    if (!pairs_) return true;
    const double length = static_cast<double>(std::abs(motion.x) + std::abs(motion.y));
    const Rect box = widen(moving.box);
    const Rect around{box.x - length, box.y - length, box.w + 2 * length, box.h + 2 * length};
    if (!grid_.near(around, static_cast<std::uint32_t>(index), budget_.left, near_)) return false;
    others_.resize(near_.size());
    for (std::size_t i = 0; i < near_.size(); ++i) others_[i] = narrow(state.bodies[near_[i]].box);
    return true;
  }

  // A body whose cells would exceed the budget stays inside the ground.
  void leave_ground(Moving<Real>& moving) {
    const TileSize tile = ground_.tile_size();
    const double columns = moving.box.w / Real(tile.width) + 2, rows = moving.box.h / Real(tile.height) + 2;
    if (columns * rows > static_cast<double>(budget_.left)) return note_cut_short();
    const auto out = way_out(ground_, moving.box, moving.foot, &budget_);
    if (budget_.left <= 0) note_cut_short();
    if (!out) return;
    moving.box.x += out->x;
    moving.box.y += out->y;
  }

  void limit(Moving<Real>& moving) {
    const auto within = [](Vec v, double most) { return std::abs(v.x) <= most && std::abs(v.y) <= most; };
    if (within(moving.velocity, kMaxBodySpeed) && within(moving.box.position(), kMaxBodyDistance)) return;
    moving.velocity = narrow(within_limits({}, widen(moving.velocity)));
    const Vec2 at = widen(moving.box.position());
    const Vec kept = narrow(within_limits(at, at));
    moving.box.x = kept.x;
    moving.box.y = kept.y;
    if (record_ != nullptr) record_->paths.back().limited = true;
  }

  // The id of the first body that contains the point, not on a side; 0 if there is none.
  static int body_at(const State& state, Vec2 point) {
    for (const Body& body : state.bodies) {
      const Rect& box = body.box;
      const bool inside =
          point.x > box.x && point.x < box.right() && point.y > box.y && point.y < box.bottom();
      if (inside) return body.id;
    }
    return 0;
  }

  // ---- Records ----

  void note_start(const Body& body) {
    if (record_ != nullptr)
      record_->paths.push_back({.body = body.id, .from = body.box, .goal = {}, .to = {}});
  }

  void note_cut_short() {
    if (record_ != nullptr) record_->paths.back().cut_short = true;
  }

  void note_goal(const Moving<Real>& moving, Vec motion) {
    if (record_ != nullptr) record_->paths.back().goal = {moving.box.x + motion.x, moving.box.y + motion.y};
  }

  Obstacle other_of(const Contact<Real>& contact) const {
    if (!contact.is_other) return obstacle_of(ground_, contact);
    const Body& body = (*bodies_)[near_[static_cast<std::size_t>(-1 - contact.origin)]];
    return {TileRole::ball, body.origin.cell, body.id, body.box};
  }

  // Notes what a contact did. change: px/frame, of the body's speed along the normal.
  void note_change(const Body& body, const Contact<Real>& contact, Real change, Real quiet) {
    if (events_ == nullptr || !(change > 0)) return;
    const double impulse = mass_of(body.kind, {body.box.w, body.box.h}) * static_cast<double>(change);
    if (record_ != nullptr) record_->contacts.back().impulse = impulse;
    if (!(change > quiet)) return;
    const int other =
        contact.is_other ? (*bodies_)[near_[static_cast<std::size_t>(-1 - contact.origin)]].id : 0;
    note_hit(events_, body.id, other, widen(contact.normal), impulse);
  }

  static void sort_by_body(std::vector<ContactRecord>& contacts) {
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const ContactRecord& a, const ContactRecord& b) { return a.body < b.body; });
  }

  // The motion that the body went on with after its last contact.
  void note_after(Vec motion) {
    if (record_ != nullptr) record_->contacts.back().after = widen(motion);
  }

  // A walking body goes on along the next piece of floor.
  void note_turn(const Body& body, const Moving<Real>& moving, Contact<Real> next, Vec motion) {
    if (record_ == nullptr) return;
    next.t = 0;
    next.position = moving.box.position();
    note(body, next, motion);
  }

  void note(const Body& body, const Contact<Real>& contact, Vec motion) {
    ContactRecord& c = record_->contacts.emplace_back();
    c.body = body.id;
    c.order = order_++;
    c.other = other_of(contact);
    c.ti = contact.t;
    c.move = widen(motion);
    c.normal = widen(contact.normal);
    c.touch = widen(contact.position);
    c.handled = true;
    c.slope = slope_probe(contact, c.other, {body.box.w, body.box.h});
  }

  const std::shared_ptr<const Scene> scene_;
  const BasicTerrain<Real>& ground_;
  const ExactNumbers<Real> numbers_;
  const std::span<const BodyTraits> kinds_;  // by BodyKind
  const Real quiet_fall_, quiet_run_;        // px/frame, of quiet_speed()
  const bool pairs_;                         // whether bodies block one another
  const int max_passes_, substeps_;
  const Real part_;                   // length of a sub-step in steps
  std::unique_ptr<Meeting> meeting_;  // null: bodies do not meet
  StepBudget step_budget_;
  CastBudget budget_;  // of the body that moves: its part of the step's
  BodyGrid grid_;
  std::vector<std::uint32_t> near_;            // indices of the bodies near the one that moves
  std::vector<BasicRect<Real>> others_;        // their boxes
  const std::vector<Body>* bodies_ = nullptr;  // of the state of the current step
  std::vector<RestMemo<Real>> rests_;          // by index of the body; not used with pairs
  StepRecord* record_ = nullptr;               // of the current step; null: it is not recorded
  std::vector<StepEvent>* events_ = nullptr;   // the same
  int order_ = 0;                              // of the body's next contact
};

}  // namespace

std::unique_ptr<Solver> make_exact_solver(std::shared_ptr<const Scene> scene) {
  assert(scene->ground || scene->single_ground);
  if (scene->single_ground) return std::make_unique<ExactSolver<float>>(std::move(scene));
  return std::make_unique<ExactSolver<double>>(std::move(scene));
}

}  // namespace talus
