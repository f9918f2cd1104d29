#include <talus/sim/body_act.h>

#include <cmath>

namespace talus {

BodyAct act_of(const Body& body) {
  constexpr double kRunSpeed = 1.0 / 16;  // px/frame
  if (body.gait.grounded || body.velocity.y == 0)
    return std::abs(body.velocity.x) < kRunSpeed ? BodyAct::stand : BodyAct::run;
  return body.velocity.y < 0 ? BodyAct::jump : BodyAct::fall;
}

}  // namespace talus
