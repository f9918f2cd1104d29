// Grabs and throws bodies.
#include "mouse.h"

#include "lerp.h"

namespace talus {

void take_mouse(State& state, const Input& input, FunctionRef<int()> under_mouse) {
  if (input.mouse_down) {
    if (input.grab != 0 && state.find(input.grab) != nullptr) state.grabbed = input.grab;
    if (state.grabbed == 0) state.grabbed = under_mouse();
    return;
  }
  if (state.grabbed == 0) return;
  for (Body& body : state.bodies) {
    if (body.id == state.grabbed) body.velocity = body.box.position() - body.previous;
  }
  state.grabbed = 0;
}

Vec2 drag_goal(const SharedTuning& t, const Body& body, const Input& input) {
  return {lerp(body.box.x, input.mouse.x - t.drag_offset, t.drag_blend),
          lerp(body.box.y, input.mouse.y - t.drag_offset, t.drag_blend)};
}

}  // namespace talus
