// What the mouse's button does to the bodies of a state: it takes one, and throws it when it is let go.
#pragma once

#include <talus/collision/function_ref.h>
#include <talus/sim/state.h>

namespace talus {

// To be called at the start of a step. A button that is down takes the body that the input names, or, while
// it holds none, the one under the mouse; one that is let go throws its body with the speed of its last
// dragged frame. under_mouse: the id of the body under the mouse, 0 for none, as the solver finds it; called
// only when it is needed.
void take_mouse(State& state, const Input& input, FunctionRef<int()> under_mouse);

// Where a body that the mouse holds wants its top-left corner: part of the way to the mouse.
Vec2 drag_goal(const SharedTuning& tuning, const Body& body, const Input& input);

}  // namespace talus
