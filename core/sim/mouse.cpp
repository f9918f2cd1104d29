// Taking and throwing bodies.
#include "mouse.h"

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

}  // namespace talus
