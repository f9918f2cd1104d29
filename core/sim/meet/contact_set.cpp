#include "contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

double inverse_mass_of(std::span<const Inertia> bodies, int index) {
  return index == Touch::kGround ? 0 : bodies[static_cast<std::size_t>(index)].inverse_mass;
}

double relative(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction, Vec2 Inertia::*what) {
  Vec2 way = bodies[static_cast<std::size_t>(touch.a)].*what;
  if (touch.b != Touch::kGround) way = way - bodies[static_cast<std::size_t>(touch.b)].*what;
  return dot(way, direction);
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

}  // namespace

double ContactSet::speed(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction) {
  return relative(touch, bodies, direction, &Inertia::velocity);
}

double ContactSet::gain(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction) {
  return relative(touch, bodies, direction, &Inertia::pull);
}

// rubs: whether friction depends on how the load is shared.
bool ContactSet::solve(bool rubs) { return rubs ? system_.solve_evenly() : system_.solve(); }

std::int64_t ContactSet::take_work() { return system_.take_work(); }

// The system of rows_: what each impulse does to the speed of each contact.
template <class Value>
void ContactSet::set_up(std::span<const Inertia> bodies, std::span<const Touch> touches, Value value) {
  system_.begin(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Touch& one = touches[rows_[i].touch];
    system_.b(i) = value(one, rows_[i].direction);
    for (std::size_t k = 0; k <= i; ++k) {
      const Touch& other = touches[rows_[k].touch];
      if (!share_a_body(one, other)) continue;
      const double turned = dot(rows_[i].direction, rows_[k].direction);
      double share = 0;
      if (one.a == other.a) share += inverse_mass_of(bodies, one.a);
      if (one.b == other.b) share += inverse_mass_of(bodies, one.b);
      if (one.a == other.b) share -= inverse_mass_of(bodies, one.a);
      if (one.b == other.a) share -= inverse_mass_of(bodies, one.b);
      system_.a(i, k) = system_.a(k, i) = share * turned;
    }
  }
}

void ContactSet::reflect(std::span<Inertia> bodies, std::span<Touch> touches) {
  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) rows_.push_back({i, touches[i].normal});
  set_up(bodies, touches, [&](const Touch& touch, Vec2 along) { return speed(touch, bodies, along); });
  const bool rubs =
      std::any_of(touches.begin(), touches.end(), [](const Touch& t) { return t.friction > 0; });
  for (std::size_t i = 0; i < rows_.size(); ++i) system_.bound(i, touches[i].is_caught ? -kAny : 0, kAny);
  solve(rubs);
  std::vector<double> given(touches.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Touch& touch = touches[i];
    given[i] = system_.x(i) * (1 + touch.bounce);
    touch.impulse += given[i];
    give(bodies, touch, &Inertia::velocity, touch.normal * given[i]);
  }

  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].friction > 0 && given[i] > 0) rows_.push_back({i, touches[i].along()});
  }
  if (rows_.empty()) return;
  set_up(bodies, touches, [&](const Touch& touch, Vec2 along) { return speed(touch, bodies, along); });
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double most = touches[rows_[i].touch].friction * given[rows_[i].touch];
    system_.bound(i, -most, most);
  }
  solve(true);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Touch& touch = touches[rows_[i].touch];
    give(bodies, touch, &Inertia::velocity, rows_[i].direction * system_.x(i));
  }
}

// The bounds of friction, from the rows of normals on, for the pressures of the last try.
void ContactSet::bound_friction(std::span<const Inertia> bodies, std::span<const Touch> touches,
                                std::size_t normals) {
  for (std::size_t i = normals; i < rows_.size(); ++i) {
    const Touch& touch = touches[rows_[i].touch];
    const double most = touch.friction * before_[rows_[i].touch];
    const double slip = speed(touch, bodies, rows_[i].direction);
    const bool slides = std::abs(slip) > kStill;
    system_.bound(i, slides && slip < 0 ? most : -most, slides && slip > 0 ? -most : most);
  }
}

void ContactSet::support(std::span<Inertia> bodies, std::span<Touch> touches) {
  rows_.clear();
  for (std::size_t i = 0; i < touches.size(); ++i) rows_.push_back({i, touches[i].normal});
  const std::size_t normals = rows_.size();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].friction > 0) rows_.push_back({i, touches[i].along()});
  }
  set_up(bodies, touches, [&](const Touch& touch, Vec2 along) { return gain(touch, bodies, along); });
  for (std::size_t i = 0; i < normals; ++i) system_.bound(i, 0, kAny);

  // Friction depends on the pressure, and the pressure on friction: each is solved for the last of the other,
  // until nothing changes. Where sliding would press a body ever more into what it slides on, it jams, and no
  // answer is finite (Painleve 1895): then friction is that of the pressures without it.
  constexpr int kMostTurns = 200;
  constexpr double kJam = 100;  // times the largest pressure without friction
  bool ends = false;
  double first = 0, largest = 0;  // pressures
  std::vector<double> unrubbed;
  before_.assign(touches.size(), 0);
  for (int turn = 0; turn < kMostTurns && !ends && !(largest > kJam * first); ++turn) {
    bound_friction(bodies, touches, normals);
    const bool is_solved = solve(rows_.size() > normals);
    ends = true;
    largest = 0;
    for (std::size_t i = 0; i < normals; ++i) {
      constexpr double kSame = 1e-13;
      const double pressure = system_.x(i);
      ends = ends && std::abs(pressure - before_[i]) <= kSame * pressure;
      before_[i] = pressure;
      largest = std::max(largest, pressure);
    }
    ends = ends && is_solved;
    if (rows_.size() == normals) break;
    if (turn == 0) {
      first = largest;
      unrubbed = before_;
    }
  }
  if (rows_.size() > normals && !ends && largest > 2 * first) {
    before_ = unrubbed;
    bound_friction(bodies, touches, normals);
    solve(true);
  }
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
    strain(touch.a, system_.x(i));
    strain(touch.b, system_.x(i));
  }
  // What is left between large pressures is rounding.
  constexpr double kRounding = 1e-13;
  for (Inertia& body : bodies) {
    if (std::abs(body.pull.x) <= kRounding * body.strain) body.pull.x = 0;
    if (std::abs(body.pull.y) <= kRounding * body.strain) body.pull.y = 0;
  }
}

}  // namespace talus
