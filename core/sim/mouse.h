// What the mouse button does to bodies: it grabs one, and throws it when the button is released.
#pragma once

#include <talus/collision/function_ref.h>
#include <talus/sim/state.h>

namespace talus {

// Call it at the start of a step. A button that goes down grabs the body that the input names; without one,
// the body under the mouse. When the button is released, the body is thrown with the speed of its last
// dragged frame. under_mouse: returns the id of the body under the mouse, 0 if there is none; called only if
// needed.
void take_mouse(State& state, const Input& input, FunctionRef<int()> under_mouse);

// Where a body that the mouse holds wants its top-left corner: part of the way to the mouse.
Vec2 drag_goal(const SharedTuning& tuning, const Body& body, const Input& input);

}  // namespace talus
