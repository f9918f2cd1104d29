#include "contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace talus {
namespace {

constexpr std::size_t kMostExact = 8;  // contacts of circles that are solved together with their friction
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
  const bool rubs_at_once = rubs && turns && rows_.size() <= kMostExact;
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
  constexpr int kMostTurns = 200;
  constexpr double kJam = 100;  // times the largest pressure without friction
  constexpr double kSame = 1e-13;
  const double same_turning = is_impact ? 1e-4 : 1e-7;
  bool ends = false;
  double first = 0, largest = 0;  // pressures
  std::vector<double> unrubbed, change, last_change, last;
  double most = 0;
  const bool hurries = any_turns(bodies);
  before_.assign(touches.size(), 0);
  for (int turn = 0; turn < kMostTurns && !ends && !(largest > kJam * first); ++turn) {
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
// are not much different (Catto 2005, "Iterative Dynamics with Temporal Coherence").
void ContactSet::stop(std::span<Inertia> bodies, std::span<Touch> touches) {
  struct Contact {
    double across = 0, along = 0;  // impulses
    double across_yields = 0, along_yields = 0;
  };
  std::vector<Contact> contacts(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Touch& touch = touches[i];
    contacts[i].across_yields = inverse_mass_of(bodies, touch.a) + inverse_mass_of(bodies, touch.b);
    contacts[i].along_yields =
        contacts[i].across_yields + inverse_spin_of(bodies, touch.a) + inverse_spin_of(bodies, touch.b);
  }
  const auto solve_one = [&](std::size_t i) {
    const Touch& touch = touches[i];
    Contact& contact = contacts[i];
    if (!(contact.across_yields > 0)) return;
    const double faster = speed(touch, bodies, touch.normal) + touch.room;
    const double across = std::max(0.0, contact.across - faster / contact.across_yields);
    give(bodies, touch, &Inertia::velocity, touch.normal * (across - contact.across));
    contact.across = across;
    if (touch.friction == 0) return;
    const double most = touch.friction * across;
    const double along = std::clamp(contact.along - slip(touch, bodies) / contact.along_yields, -most, most);
    give(bodies, touch, &Inertia::velocity, touch.along() * (along - contact.along));
    turn(bodies, touch, &Inertia::spin, along - contact.along);
    contact.along = along;
  };
  constexpr int kTimes = 50;
  for (int turn = 0; turn < kTimes; ++turn) {
    for (std::size_t i = 0; i < touches.size(); ++i) solve_one(i);
    for (std::size_t i = touches.size(); i-- > 0;) solve_one(i);
  }
  for (std::size_t i = 0; i < touches.size(); ++i) touches[i].pressure = contacts[i].across;
  work_ += static_cast<std::int64_t>(touches.size()) * kTimes * 2;
}

void ContactSet::settle(std::span<Inertia> bodies, std::span<const Touch> touches) {
  rows_.clear();
  bool moves = false;
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
  if (!moves) return;
  set_up_speeds(bodies, touches);
  for (std::size_t i = 0; i < rows_.size(); ++i) system_.bound(i, -kAny, kAny);
  solve(true);
  push_all(bodies, touches);
}

}  // namespace talus
