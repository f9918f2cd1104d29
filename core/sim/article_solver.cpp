#include "article_solver.h"

#include <algorithm>
#include <cmath>

#include "lerp.h"
#include "mouse.h"

namespace talus {
namespace {

constexpr World::GroupResponses kProbing = {Response::ignore, Response::cross, Response::ignore};

}  // namespace

ArticleSolver::ArticleSolver(std::shared_ptr<const Scene> scene) : WorldSolver(std::move(scene)) {}

void ArticleSolver::fall(Body& body, Placed& placed) {
  const SharedTuning& t = tuning();
  pull(body);
  move(body, placed, body.box.position() + body.velocity);

  for (std::size_t i = 0; i < hits_.size(); ++i) {
    ContactRecord* contact = contact_of_hit(i);
    if (entry(hits_[i].other).is_slope()) {
      const std::optional<SlopeProbe> probe = settle_on_slope(body, placed, body.velocity.y, contact);
      if (!probe || !probe->corrected) continue;
      body.velocity.x = body.velocity.x + probe->normal.x;
      body.velocity.y = (-body.velocity.y - probe->normal.y) * t.slope_bounce;
      break;
    }
    if (contact != nullptr) contact->handled = true;
    if (hits_[i].normal.y != 0) {
      body.velocity.y = -(body.velocity.y * t.floor_bounce);
      body.velocity.x = body.velocity.x * t.floor_grip;
    }
    if (hits_[i].normal.x != 0) body.velocity.x = -(body.velocity.x * t.wall_bounce);
  }
  limit_velocity(body);
}

void ArticleSolver::drag(Body& body, Placed& placed, const Input& input) {
  body.previous = body.box.position();
  move(body, placed, drag_goal(tuning(), body, input));
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!entry(hits_[i].other).is_slope()) continue;
    settle_on_slope(body, placed, tuning().drag_probe, contact_of_hit(i));
  }
}

// The article's slope(obj): looks straight down by `speed` for the first slope that is not met from below,
// and interpolates its floor at the body's centre.
std::optional<SlopeProbe> ArticleSolver::probe_slope(const Body& body, const Placed& placed, double speed) {
  if (!(speed >= 0)) return std::nullopt;
  check(placed, {body.box.x, body.box.y + speed}, kProbing, slope_hits_);
  const auto hit = std::find_if(slope_hits_.begin(), slope_hits_.end(),
                                [](const Collision& h) { return h.normal.y != 1; });
  if (hit == slope_hits_.end()) return std::nullopt;

  const Entry& found = entry(hit->other);
  const Rect& box = found.what.box;
  SlopeProbe probe;
  probe.slope = found.what;
  probe.delta = std::max(0.0, std::min((body.box.x + body.box.w / 2) - box.x, box.w)) / box.w;
  const double offset =
      found.slope.direction > 0 ? lerp(box.h, 0, probe.delta) : lerp(0.0, box.h, probe.delta);
  const double top = (box.y - box.h) + offset;
  probe.floor_y = top + body.box.h;
  probe.placed_y = std::floor(top);
  probe.normal = slope_normal(found.slope);
  return probe;
}

// Puts the body on the slope's floor if it is below the floor.
std::optional<SlopeProbe> ArticleSolver::settle_on_slope(Body& body, Placed& placed, double speed,
                                                         ContactRecord* contact) {
  std::optional<SlopeProbe> probe = probe_slope(body, placed, speed);
  if (probe && body.box.y >= probe->placed_y) {
    probe->corrected = true;
    body.box.y = probe->placed_y;
    place(placed, body.box);
  }
  if (contact != nullptr) {
    contact->handled = true;
    contact->slope = probe;
  }
  return probe;
}

}  // namespace talus
