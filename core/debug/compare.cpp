#include "compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "number_text.h"

namespace talus {
namespace {

constexpr double kAlone = std::numeric_limits<double>::infinity();

auto key_of(const BodyOrigin& origin) { return std::make_tuple(origin.spawn, origin.cell.x, origin.cell.y); }

// Mostly a body has the same id in both branches.
const Body* same_body(const Body& body, const State& other) {
  const Body* same = other.find(body.id);
  if (same != nullptr && same->origin == body.origin) return same;
  const auto at = std::find_if(other.bodies.begin(), other.bodies.end(),
                               [&](const Body& b) { return b.origin == body.origin; });
  return at == other.bodies.end() ? nullptr : &*at;
}

double distance(const Body& a, const Body& b) {
  const Vec2 d = b.box.position() - a.box.position();
  return std::sqrt(dot(d, d));
}

}  // namespace

std::vector<BodyDifference> differences(const State& a, const State& b) {
  std::map<std::tuple<int, int, int>, const Body*> of_b;
  for (const Body& body : b.bodies) of_b.emplace(key_of(body.origin), &body);
  std::vector<BodyDifference> all;
  for (const Body& body : a.bodies) {
    const auto at = of_b.find(key_of(body.origin));
    if (at == of_b.end()) {
      all.push_back({body.id, 0, {}, {}, kAlone});
      continue;
    }
    const Body& same = *at->second;
    all.push_back({body.id, same.id, same.box.position() - body.box.position(), same.velocity - body.velocity,
                   distance(body, same)});
    of_b.erase(at);
  }
  const std::size_t alone = all.size();
  for (const auto& [origin, body] : of_b) all.push_back({0, body->id, {}, {}, kAlone});
  std::sort(all.begin() + static_cast<std::ptrdiff_t>(alone), all.end(),
            [](const BodyDifference& x, const BodyDifference& y) { return x.b < y.b; });
  return all;
}

double parting_of(const Body& body, const State& other) {
  const Body* same = same_body(body, other);
  return same != nullptr ? distance(body, *same) : kAlone;
}

void ComparedFrames::read(std::int64_t frame, Frame& into) const {
  std::optional<State> other;
  if (has_other(frame)) {
    b_->read(frame, into);
    other = std::move(into.state);
  }
  a_.read(frame, into);
  into.other = std::move(other);
}

bool ComparedFrames::approach(std::int64_t frame) const {
  return (!has_other(frame) || b_->approach(frame)) && a_.approach(frame);
}

std::string parting_condition(double threshold) { return "parting > " + exact_text(threshold); }

}  // namespace talus
