// Meeting: a step of bodies that meet, for the tuning `bodies: meet` of the exact solver. All bodies move at
// the same time, from one contact to the next: nothing depends on their order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <talus/sim/solver.h>
#include "../body_grid.h"
#include "contact_set.h"
#include "ground_probe.h"
#include "round_ground.h"
#include "track.h"

namespace talus {

class Meeting {
 public:
  // scene: not null, with a ground in double precision.
  explicit Meeting(std::shared_ptr<const Scene> scene);

  // Whether step() moves a body. The others have moved already, and stand like walls: players that the mouse
  // does not hold.
  bool moves(const Body& body, const State& state) const;
  // Takes the bodies of a state one step further. record: null, or has the paths of all bodies, in the order
  // of the state. events: null, or gets those of the bodies that it moves. Returns the work that it took.
  std::int64_t step(State& state, const Input& input, StepRecord* record, std::vector<StepEvent>* events);

 private:
  // Events of one body in a part of a step, after which it is to come to rest.
  static constexpr int kMaxSlowEvents = 6;
  static constexpr int kAll = 1 << 30;             // as reach_: there is no bound
  static constexpr double kTouching = 1.0 / 1024;  // px: two that are slow, one of them a circle, touch
  static constexpr double kNearCircle = 1.0 / 16;  // px: they may come to meet in a part of a step

  // What only circles have.
  struct Circle {
    double spin = 0, spin_pull = 0;  // px/frame and px/frame^2 of its rim, clockwise, at the time of its path
    double inverse_spin = 0;         // as in Inertia
    double turned = 0;               // px of its rim, in this step
    GroundSide ground = {};          // that its path leads to
  };

  // What a body has learnt of a conveyor that it touches.
  struct Belt {
    Vec2 normal;       // of the contact; 0: none
    double speed = 0;  // px/frame
  };
  // Of level and of upright ground, since this part of the step began, or it met other ground.
  using Belts = std::array<Belt, 2>;

  // A body in a step.
  struct Member {
    MovingBox moving = {};
    Rect swept = {};          // px: holds all places of its path in this part of the step
    Vec2 pull = {};           // px/frame^2, where nothing holds it
    double inverse_mass = 0;  // 0: nothing moves it in this step
    double friction = 0;
    double floor_bounce = 0, wall_bounce = 0;
    std::uint32_t version = 0;  // of its path; an event of an older one is void
    int events = 0;             // that it had in this part of the step
    double bounced = -1;    // frames since the part of the step began: the last time; less than 0: not yet
    int order = 0;          // of its next contact in the record
    bool is_swept = false;  // `swept` is that of its path in this part
    int place_in_set = -1;
    int depth = 0;          // in the set: so many contacts are between it and the event
    bool is_inner = false;  // of the set that is resolved, and solved with it
    bool is_cut = false;    // it was solved with a part of those that it touches
    bool is_grounded = false;
    bool is_steady = false;  // nothing changed its velocity before the step began
    bool is_late = false;    // it was solved after the beginning of the step
    bool is_parted = false;  // it was moved out of another one before the step began
    bool is_held = false;    // by the mouse
    bool is_asleep = false;  // it rests as in the step before; nothing looks for what it meets
    bool is_capped = false;
    bool is_spent = false;      // it is in a crowd, and has got what its pull gives it in this part
    GroundMeeting ground = {};  // that its path leads to
    Circle* circle = nullptr;   // null: it is a box
    Track* track = nullptr;     // null: it never needs one, as a box where there are no curves
    bool is_on_track() const { return track != nullptr && track->is_on; }
    void leave_track() const {
      if (track == nullptr) return;
      track->is_on = false;
      track->leaves = nullptr;
    }
    // One that is capped stands still from then on.
    bool may_have_moved() const { return inverse_mass > 0 || is_capped; }
  };
  // What happens next to one or two bodies.
  struct Event {
    enum class Kind : std::uint8_t { ground, turn, pair };
    double time = 0;  // frames since the part of the step began
    Kind kind = Kind::pair;
    Vec2 place = {};             // px, of the first body when this was found: it orders events at one time
    std::uint32_t a = 0, b = 0;  // indices; b: of a pair
    std::uint32_t version_a = 0, version_b = 0;
    Vec2 normal = {};  // of a pair, out of b
    bool is_pair_of(std::uint32_t one, std::uint32_t other) const {
      return kind == Kind::pair && ((one == a && other == b) || (one == b && other == a));
    }
  };
  // What touches in a set, beside Touch: the piece of ground, or nothing for two bodies.
  struct Met {
    Touch touch;
    Contact<double> contact;
    int side = -1;  // in sides_, if a circle touches something; -1: two boxes, or a box and the ground
    bool is_round() const { return side >= 0; }
    bool is_track = false;  // a body in it goes along the other one: a circle, or a box along a curve
    bool is_apart = false;  // two that do not touch yet, but are near, one of which is a circle
  };

  // A body after a step.
  struct Rest {
    Rect box;
    Vec2 velocity;
    std::uint32_t island = 0;  // from 1; 0: none
    int events = 0;            // as Member::events, after it was solved
    bool is_spent = false;     // the same for Member::is_spent
    bool is_of(const Body& body) const { return body.box == box && body.velocity == velocity; }
    // The same for a body that the step moved: nothing has changed it, nor the scene, since.
    bool is_left_in(const Body& body) const { return is_of(body) && body.is_clear; }
  };
  // Bodies that were solved with one another, and rest; and those that they rest against.
  struct Island {
    std::size_t first = 0, end = 0;  // in in_islands_
    bool is_same = true;             // no bit of them has changed since
  };

  // meeting.cpp
  void take(State& state, const Input& input);
  void run_part();
  void stop_early(double now);
  static void stop(Member& member);
  void give(State& state);
  bool is_as_left(const State& state) const;
  void part_overlaps(bool are_apart);
  Vec2 way_apart(std::uint32_t index);
  void set_off(std::uint32_t index);
  void sweep(std::uint32_t index);
  void look_for_ground(std::uint32_t index);
  std::pair<std::uint32_t, std::uint32_t> in_order(std::uint32_t a, std::uint32_t b, double time) const;
  void look_for_pairs(std::uint32_t index, bool only_later);
  void push(Event event);
  bool is_void(const Event& event) const;
  static bool is_later(const Event& a, const Event& b);

  // meeting_rest.cpp
  void fall_asleep(const State& state);
  void keep_sleeping_islands();
  template <class Holds>
  bool all_of(const Island& island, Holds holds) const;
  void wake_touched();
  void wake_beside(std::uint32_t index);
  void remember_set();
  bool is_unchanged(std::uint32_t index) const;
  void form_islands();
  void remember(const State& state);

  // meeting_tracks.cpp
  void go_to(Member& member, double time);
  Form form_of(std::uint32_t index);
  bool goes_along(const Member& member, std::uint32_t other) const;
  void align(const Met& met, bool stays);
  bool add_side(std::size_t place, const SideTouch& touch, bool is_sorted = true);
  void add_ground_of_circles();
  const SideTouch& side_of(const Met& met) const { return sides_[static_cast<std::size_t>(met.side)]; }
  bool probe_circle(std::size_t place, Vec2 way, double fastest);
  Vec2 take_along(const Track& track, MovingBox& moving, double time);
  std::optional<SideTouch> curve_of(const Met& met);
  std::optional<GroundSide> next_curve(const GroundSide& last, Vec2 corner, double way);
  bool is_too_narrow(const Nearness& near, std::size_t place) const;
  void find_track_of_circle(std::size_t place);
  void find_track_of_box(std::size_t place);
  void find_tracks();
  void begin_track(const Met& met);
  bool follow_ground(Member& member, Vec2 normal);
  void begin_track_of_box(const Met& met);
  void keep_pace(Member& member, double bend, Vec2 normal) const;
  bool is_moving(std::size_t place) const;
  void drive(Track& track, const Met& met, int place, Vec2 normal) const;
  bool follow_body(Track& track, const Nearness& near, int other);
  std::optional<GroundMeeting> next_meeting(const Member& member, double to);
  void meet_on_track(const Member& member, double to, GroundMeeting& met) const;
  void look_for_end_of_track(std::uint32_t index);

  // meeting_crowd.cpp
  Rect area_of_set(const Form& form) const;
  std::optional<Vec2> touching_in_set(std::uint32_t a, std::uint32_t b);
  double hit_of(const Event& event) const;
  bool is_gentle(const Event& event) const;
  bool is_crowd() const;
  int first_reach(const Event& event) const;
  bool reaches_further();
  void spend_pulls();
  void add_near_ground(std::size_t place);
  void give_pulls(double rest);
  void bounce_crowd();
  void move_on();
  bool stick();
  double crowd_left() const { return std::max(kStill, slowest_ / 4096); }  // px/frame
  double crowd_still() const { return slowest_ / 64; }                     // px/frame

  // meeting_set.cpp
  void gather(const Event& event);
  void join(std::uint32_t index, int depth);
  void look_around(std::size_t place, const Event& event);
  void add_pairs(const Event& event);
  void sort_by_place(std::span<std::uint32_t> indices) const;
  bool shakes_more();
  bool is_inner(std::size_t place) const { return members_[set_[place]].is_inner; }

  // meeting_contacts.cpp
  void resolve(const Event& event);
  void set_paths();
  void stop_set();
  double conveyor_under(const Met& met);
  void add_ground(std::size_t place, Vec2 normal, const Contact<double>& contact, int side = -1,
                  bool is_sorted = true);
  void sort_met();
  bool leaves_crest(std::size_t place, const Contact<double>& contact);
  bool probe(std::size_t place, Vec2 way, double fastest);
  bool is_new(std::size_t place, Vec2 normal) const;
  void bounce();
  void level_out();
  bool choose(bool is_late);
  bool is_level(Vec2 normal) const;
  bool is_dragged() const;
  double bounce_of(const Touch& touch) const;
  double slowest_on(const Touch& touch) const;
  bool bounced_lately(const Touch& touch) const;
  bool is_restless(int place) const;
  bool is_dozing() const;
  void hold();
  void look_for_turn(const Met& met);
  void note_contacts();
  void note_hits();
  void note(const Met& met, int place, int other, Vec2 normal, bool stops);

  const std::shared_ptr<const Scene> scene_;
  const GroundProbe probe_;
  RoundGround round_;
  const Vec2 gravity_;    // px/frame^2
  const double slowest_;  // px/frame, that a bounce must have on level ground
  const double slow_;     // px/frame, as Touch::slow, of circles
  const double quiet_;    // px/frame, of quiet_speed()
  const int parts_;
  const double part_;  // frames
  BodyGrid grid_;
  CastBudget budget_;
  std::vector<Member> members_;  // by index of the body
  std::vector<Circle> circles_;  // the same; empty if there are none
  std::vector<Track> tracks_;    // the same; empty if there are neither circles nor curves
  std::vector<Belts> belts_;     // the same; empty if there are no conveyors
  std::vector<Rest> rests_;      // the same
  std::vector<Island> islands_;
  std::vector<std::uint32_t> in_islands_;  // indices of bodies
  std::vector<std::uint32_t> solved_;      // the same, of the sets of the first part, one after the other
  std::vector<std::size_t> solved_ends_;   // of the sets, in solved_
  std::vector<Event> events_;              // a heap, the earliest first
  std::vector<std::uint32_t> near_;
  // Of the set that is resolved.
  double time_ = 0;     // frames since the part of the step began
  double started_ = 0;  // frames since the step began, of its part
  double hit_ = 0;      // px/frame: how fast the event closes a gap
  bool is_gentle_ = false;
  int reach_ = kAll;  // what is deeper in the set is not solved
  std::vector<std::uint32_t> set_;
  std::vector<std::uint32_t> shaken_;                           // those that must be in it
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // of it that touch
  std::vector<Vec2> before_;                                    // px/frame, their velocities
  std::vector<Inertia> inertias_;
  std::vector<Met> met_;
  std::vector<SideTouch> sides_;  // of contacts that a circle has; of two bodies without a side of the ground
  std::vector<Touch> chosen_;
  std::vector<std::size_t> chosen_at_;
  ContactSet contacts_;
  const State* state_ = nullptr;
  StepRecord* record_ = nullptr;
  std::vector<StepEvent>* step_events_ = nullptr;
  bool leaves_apart_ = false;  // the last step cannot have left two bodies inside of one another
  bool is_stopped_ = false;    // the work that a step may take is used up
};

}  // namespace talus
