#include "contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace talus {
namespace {

constexpr std::size_t kMaxExact = 8;  // contacts of circles that are solved together with their friction
constexpr double kAny = std::numeric_limits<double>::infinity();

double inverse_mass_of(std::span<const Inertia> bodies, int index) {
  return index == Touch::kGround ? 0 : bodies[static_cast<std::size_t>(index)].inverse_mass;
}

double inverse_spin_of(std::span<const Inertia> bodies, int index) {
  return index == Touch::kGround ? 0 : bodies[static_cast<std::size_t>(index)].inverse_spin;
}

double relative(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction, Vec2 Inertia::*what) {
  Vec2 way = bodies[static_cast<std::size_t>(touch.a)].*what;
  if (touch.b != Touch::kGround) way = way - bodies[static_cast<std::size_t>(touch.b)].*what;
  return dot(way, direction);
}

// Two that turn the same way rub against one another.
double turning(const Touch& touch, std::span<const Inertia> bodies, double Inertia::*what) {
  const double one = bodies[static_cast<std::size_t>(touch.a)].*what;
  return touch.b == Touch::kGround ? one : one + bodies[static_cast<std::size_t>(touch.b)].*what;
}

bool any_turns(std::span<const Inertia> bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [](const Inertia& body) { return body.inverse_spin > 0; });
}

bool share_a_body(const Touch& a, const Touch& b) {
  return a.a == b.a || a.a == b.b || a.b == b.a || (a.b == b.b && a.b != Touch::kGround);
}

// Gives both bodies of a contact an impulse.
void give(std::span<Inertia> bodies, const Touch& touch, Vec2 Inertia::*what, Vec2 impulse) {
  Inertia& a = bodies[static_cast<std::size_t>(touch.a)];
  a.*what = a.*what + impulse * a.inverse_mass;
  if (touch.b == Touch::kGround) return;
  Inertia& b = bodies[static_cast<std::size_t>(touch.b)];
  b.*what = b.*what - impulse * b.inverse_mass;
}

// The same for friction, which turns circles, too.
void turn(std::span<Inertia> bodies, const Touch& touch, double Inertia::*what, double impulse) {
  Inertia& a = bodies[static_cast<std::size_t>(touch.a)];
  if (a.inverse_spin != 0) a.*what -= impulse * a.inverse_spin;
  if (touch.b == Touch::kGround) return;
  Inertia& b = bodies[static_cast<std::size_t>(touch.b)];
  if (b.inverse_spin != 0) b.*what -= impulse * b.inverse_spin;
}

}  // namespace

double ContactSet::speed(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction) {
  return relative(touch, bodies, direction, &Inertia::velocity);
}

double ContactSet::gain(const Touch& touch, std::span<const Inertia> bodies) {
  return relative(touch, bodies, touch.normal, &Inertia::pull) + touch.parts;
}

double ContactSet::slip(const Touch& touch, std::span<const Inertia> bodies) {
  return relative(touch, bodies, touch.along(), &Inertia::velocity) - turning(touch, bodies, &Inertia::spin) -
         touch.conveyor;
}

// rubs: whether friction depends on how the load is shared.
bool ContactSet::solve(bool rubs) { return rubs ? system_.solve_evenly() : system_.solve(); }

std::int64_t ContactSet::take_work() { return system_.take_work() + std::exchange(work_, 0); }

// The system of rows_: what each impulse does to the speed of each contact.
template <class Value>
void ContactSet::set_up(std::span<const Inertia> bodies, std::span<const Touch> touches, Value value) {
  system_.begin(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Touch& one = touches[rows_[i].touch];
    system_.b(i) = value(rows_[i]);
    for (std::size_t k = 0; k <= i; ++k) {
      const Touch& other = touches[rows_[k].touch];
      if (!share_a_body(one, other)) continue;
      const double turned = dot(rows_[i].direction, rows_[k].direction);
      double share = 0;
      if (one.a == other.a) share += inverse_mass_of(bodies, one.a);
      if (one.b == other.b) share += inverse_mass_of(bodies, one.b);
      if (one.a == other.b) share -= inverse_mass_of(bodies, one.a);
      if (one.b == other.a) share -= inverse_mass_of(bodies, one.b);
      double yields = share * turned;
      if (rows_[i].rubs && rows_[k].rubs) {
        if (one.a == other.a || one.a == other.b) yields += inverse_spin_of(bodies, one.a);
        if (one.b != Touch::kGround && (one.b == other.b || one.b == other.a))
          yields += inverse_spin_of(bodies, one.b);
      }
      system_.a(i, k) = system_.a(k, i) = yields;
    }
  }
}

// The same for the speeds of the contacts, along and across.
void ContactSet::set_up_speeds(std::span<const Inertia> bodies, std::span<const Touch> touches) {
  set_up(bodies, touches, [&](const Row& row) {
    const Touch& touch = touches[row.touch];
    return row.rubs ? slip(touch, bodies) : speed(touch, bodies, row.direction);
  });
}

// Gives both bodies of a contact the impulse of a row.
void ContactSet::push(std::span<Inertia> bodies, const Touch& touch, const Row& row, double impulse) {
  give(bodies, touch, &Inertia::velocity, row.direction * impulse);
  if (row.rubs) turn(bodies, touch, &Inertia::spin, impulse);
}
void ContactSet::push_all(std::span<Inertia> bodies, std::span<const Touch> touches) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    push(bodies, touches[rows_[i].touch], rows_[i], system_.x(i));
}

void ContactSet::reflect(std::span<Inertia> bodies, std::span<Touch> touches) {
  const bool rubs =
      std::any_of(touches.begin(), touches.end(), [](const Touch& t) { return t.friction > 0; });
  const bool turns = any_turns(bodies);
  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) rows_.push_back({i, touches[i].normal});
  const std::size_t normals = rows_.size();
  const bool rubs_at_once = rubs && turns && rows_.size() <= kMaxExact;
  if (rubs_at_once) add_friction(touches);
  set_up_speeds(bodies, touches);
  for (std::size_t i = 0; i < normals; ++i) system_.bound(i, touches[i].is_caught ? -kAny : 0, kAny);
  // Friction that turns a circle presses it against what it touches elsewhere.
  if (rubs_at_once)
    solve_with_friction(bodies, touches, normals, true);
  else
    solve(rubs);
  std::vector<double> given(touches.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Touch& touch = touches[rows_[i].touch];
    if (rows_[i].rubs) {
      push(bodies, touch, rows_[i], system_.x(i));
      continue;
    }
    given[i] = system_.x(i) * (1 + touch.bounce);
    touch.impulse += given[i];
    push(bodies, touch, rows_[i], given[i]);
    if (rubs_at_once) given[i] = system_.x(i) * touch.bounce;  // the rest has rubbed
  }
  rub(bodies, touches, given);
}

// Friction of impulses along the normals.
void ContactSet::rub(std::span<Inertia> bodies, std::span<Touch> touches, std::span<const double> given) {
  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].friction > 0 && given[i] > 0) rows_.push_back({i, touches[i].along(), true});
  }
  if (rows_.empty()) return;
  set_up_speeds(bodies, touches);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double most = touches[rows_[i].touch].friction * given[rows_[i].touch];
    system_.bound(i, -most, most);
  }
  solve(true);
  push_all(bodies, touches);
}

void ContactSet::add_friction(std::span<const Touch> touches) {
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].friction > 0) rows_.push_back({i, touches[i].along(), true});
  }
}

// The bounds of friction, from the rows of normals on, for the pressures of the last try. An impact may end
// what slides; a pull works against it.
void ContactSet::bound_friction(std::span<const Inertia> bodies, std::span<const Touch> touches,
                                std::size_t normals, bool is_impact) {
  for (std::size_t i = normals; i < rows_.size(); ++i) {
    const Touch& touch = touches[rows_[i].touch];
    const double most = touch.friction * std::max(before_[rows_[i].touch], 0.0);
    const double slides = is_impact ? 0 : slip(touch, bodies);
    const bool is_sliding = std::abs(slides) > std::max(kStill, touch.slow);
    system_.bound(i, is_sliding && slides < 0 ? most : -most, is_sliding && slides > 0 ? -most : most);
  }
}

// The next pressures to try, from the last two tries: the sum of the two, with weights of 1 in all, whose
// change is least (Anderson 1965, "Iterative procedures for nonlinear integral equations", with a depth of
// 1).
void ContactSet::hurry(std::span<const double> change, std::span<const double> last_change,
                       std::vector<double>& last) {
  double product = 0, square = 0;
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double apart = change[i] - last_change[i];
    product += change[i] * apart;
    square += apart * apart;
  }
  const double share = square > 0 ? product / square : 0;
  std::vector<double> now(before_.begin(), before_.begin() + static_cast<std::ptrdiff_t>(change.size()));
  if (last.size() == change.size()) {
    for (std::size_t i = 0; i < change.size(); ++i)
      before_[i] = std::max(0.0, now[i] - share * (now[i] - last[i]));
  }
  last = std::move(now);
}

// Friction depends on the pressure, and the pressure on friction: each is solved for the last of the other,
// until nothing changes. Where sliding would press a body ever more into what it slides on, it jams, and no
// answer is finite (Painleve 1895): then friction is that of the pressures without it.
void ContactSet::solve_with_friction(std::span<const Inertia> bodies, std::span<const Touch> touches,
                                     std::size_t normals, bool is_impact) {
  constexpr int kMaxTurns = 200;
  constexpr double kJam = 100;  // times the largest pressure without friction
  constexpr double kSame = 1e-13;
  const double same_turning = is_impact ? 1e-4 : 1e-7;
  bool ends = false;
  double first = 0, largest = 0;  // pressures
  std::vector<double> unrubbed, change, last_change, last;
  double most = 0;
  const bool hurries = any_turns(bodies);
  before_.assign(touches.size(), 0);
  for (int turn = 0; turn < kMaxTurns && !ends && !(largest > kJam * first); ++turn) {
    bound_friction(bodies, touches, normals, is_impact);
    const bool is_solved = solve(rows_.size() > normals);
    ends = true;
    largest = 0;
    for (std::size_t i = 0; i < normals; ++i) {
      const double pressure = system_.x(i);
      ends = ends && std::abs(pressure - before_[i]) <= (hurries ? same_turning * most : kSame * pressure);
      if (hurries) change.push_back(pressure - before_[i]);
      before_[i] = pressure;
      largest = std::max(largest, pressure);
    }
    most = std::max(most, largest);
    ends = ends && is_solved;
    if (hurries && turn > 1 && !ends) hurry(change, last_change, last);
    last_change = std::exchange(change, {});
    if (rows_.size() == normals) break;
    if (turn == 0) {
      first = largest;
      unrubbed = before_;
    }
  }
  if (rows_.size() > normals && !ends && largest > 2 * first) {
    before_ = unrubbed;
    bound_friction(bodies, touches, normals, is_impact);
    solve(true);
  }
}

void ContactSet::support(std::span<Inertia> bodies, std::span<Touch> touches) {
  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) rows_.push_back({i, touches[i].normal});
  const std::size_t normals = rows_.size();
  add_friction(touches);
  set_up(bodies, touches, [&](const Row& row) {
    const Touch& touch = touches[row.touch];
    if (!row.rubs) return gain(touch, bodies);
    return relative(touch, bodies, row.direction, &Inertia::pull) -
           turning(touch, bodies, &Inertia::spin_pull);
  });
  for (std::size_t i = 0; i < normals; ++i) system_.bound(i, 0, kAny);
  solve_with_friction(bodies, touches, normals, false);
  for (Inertia& body : bodies) body.strain = 0;
  const auto strain = [&](int index, double pressure) {
    if (index == Touch::kGround) return;
    Inertia& body = bodies[static_cast<std::size_t>(index)];
    body.strain = std::max(body.strain, std::abs(pressure) * body.inverse_mass);
  };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Touch& touch = touches[rows_[i].touch];
    if (i < normals) touch.pressure = system_.x(i);
    give(bodies, touch, &Inertia::pull, rows_[i].direction * system_.x(i));
    if (rows_[i].rubs) {
      touch.rubbing = system_.x(i);
      turn(bodies, touch, &Inertia::spin_pull, system_.x(i));
    }
    strain(touch.a, system_.x(i));
    strain(touch.b, system_.x(i));
  }
  // What is left between large pressures is rounding.
  constexpr double kRounding = 1e-13;
  for (Inertia& body : bodies) {
    if (std::abs(body.pull.x) <= kRounding * body.strain) body.pull.x = 0;
    if (std::abs(body.pull.y) <= kRounding * body.strain) body.pull.y = 0;
    if (std::abs(body.spin_pull) <= kRounding * body.strain) body.spin_pull = 0;
  }
}

// Sequential impulses: each contact is solved alone, again and again, in both orders, so that mirrored sets
// are not much different (Catto 2005, "Iterative Dynamics with Temporal Coherence"). A load goes through a
// pile slowly that way. So each turn begins further on along the way of the last two, ever further until it
// would go back (Nesterov 1983; O'Donoghue and Candes 2015, "Adaptive Restart for Accelerated Gradient
// Schemes").
void ContactSet::stop(std::span<Inertia> bodies, std::span<Touch> touches, double still, int most_turns) {
  take_stops(bodies, touches);
  double pace = 1;
  for (int turn = 1; turn <= most_turns; ++turn) {
    for (Stop& stop : stops_) stop.tried = stop.given;
    for (std::size_t i = 0; i < stops_.size(); ++i) stop_one(bodies, stops_[i]);
    for (std::size_t i = stops_.size(); i-- > 0;) stop_one(bodies, stops_[i]);
    work_ += 2 * static_cast<std::int64_t>(stops_.size());
    double back = 0, largest = 0;  // largest: px/frame
    for (const Stop& stop : stops_) {
      const Vec2 change = stop.given - stop.tried;
      back -= dot(change, stop.given - stop.last);
      largest = std::max({largest, std::abs(change.x) * stop.yields, std::abs(change.y) * stop.rim_yields});
    }
    if (largest <= still || turn == most_turns) break;
    if (back > 0) pace = 1;
    const double next = (1 + std::sqrt(1 + 4 * pace * pace)) / 2, share = (pace - 1) / next;
    pace = next;
    for (Stop& stop : stops_) {
      const Vec2 onward = (stop.given - stop.last) * share;
      stop.last = stop.given;
      push_stop(bodies, stop, onward);
    }
  }
  for (const Stop& stop : stops_) {
    touches[stop.touch].pressure = stop.given.x;
    touches[stop.touch].rubbing = stop.given.y;
  }
}

// The contacts that can change anything.
void ContactSet::take_stops(std::span<const Inertia> bodies, std::span<const Touch> touches) {
  stops_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Touch& touch = touches[i];
    const double yields = inverse_mass_of(bodies, touch.a) + inverse_mass_of(bodies, touch.b);
    if (!(yields > 0)) continue;
    Stop& stop = stops_.emplace_back();
    stop.touch = i;
    stop.a = touch.a;
    stop.b = touch.b;
    stop.normal = touch.normal;
    stop.room = touch.room;
    stop.friction = touch.friction;
    stop.conveyor = touch.conveyor;
    stop.yields = yields;
    stop.rim_yields = yields + inverse_spin_of(bodies, touch.a) + inverse_spin_of(bodies, touch.b);
    stop.given = stop.last = {touch.pressure, touch.rubbing};
  }
}

void ContactSet::push_stop(std::span<Inertia> bodies, Stop& stop, Vec2 change) {
  stop.given = stop.given + change;
  const Vec2 impulse = stop.normal * change.x + talus::along(stop.normal) * change.y;
  Inertia& a = bodies[static_cast<std::size_t>(stop.a)];
  a.velocity = a.velocity + impulse * a.inverse_mass;
  a.spin -= change.y * a.inverse_spin;
  if (stop.b == Touch::kGround) return;
  Inertia& b = bodies[static_cast<std::size_t>(stop.b)];
  b.velocity = b.velocity - impulse * b.inverse_mass;
  b.spin -= change.y * b.inverse_spin;
}

void ContactSet::stop_one(std::span<Inertia> bodies, Stop& stop) {
  const Inertia& a = bodies[static_cast<std::size_t>(stop.a)];
  Vec2 way = a.velocity;
  double turning = a.spin;
  if (stop.b != Touch::kGround) {
    const Inertia& b = bodies[static_cast<std::size_t>(stop.b)];
    way = way - b.velocity;
    turning += b.spin;
  }
  const double faster = dot(way, stop.normal) + stop.room;
  const double across = std::max(0.0, stop.given.x - faster / stop.yields);
  const double most = stop.friction * across;
  const double slips = dot(way, talus::along(stop.normal)) - turning - stop.conveyor;
  const double along = std::clamp(stop.given.y - slips / stop.rim_yields, -most, most);
  push_stop(bodies, stop, Vec2{across, along} - stop.given);
}

bool ContactSet::settle(std::span<Inertia> bodies, std::span<const Touch> touches) {
  rows_.clear();
  bool moves = false;
  const auto slides = [&](const Touch& touch) {
    return touch.friction > 0 && std::abs(slip(touch, bodies)) > std::max(kStill, touch.slow);
  };
  const auto all_sliding = [&] { return std::count_if(touches.begin(), touches.end(), slides); };
  const auto slid = all_sliding();
  const auto add = [&](std::size_t touch, Vec2 direction, bool rubs, double speed) {
    if (std::abs(speed) > std::max(touches[touch].still(), touches[touch].slow)) return;
    rows_.push_back({touch, direction, rubs});
    moves = moves || speed != 0;
  };
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Touch& touch = touches[i];
    if (!(touch.pressure > 0)) continue;
    constexpr double kAlmost = 1 - 1e-9;
    add(i, touch.normal, false, speed(touch, bodies, touch.normal));
    if (std::abs(touch.rubbing) < kAlmost * touch.friction * touch.pressure)
      add(i, touch.along(), true, slip(touch, bodies));
  }
  if (!moves) return false;
  set_up_speeds(bodies, touches);
  for (std::size_t i = 0; i < rows_.size(); ++i) system_.bound(i, -kAny, kAny);
  solve(true);
  push_all(bodies, touches);
  return all_sliding() < slid;
}

}  // namespace talus
