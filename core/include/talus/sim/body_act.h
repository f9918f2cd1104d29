// What a body does, for its picture.
#pragma once

#include <talus/level/body_picture.h>
#include <talus/sim/state.h>

namespace talus {

// A body that stands on something, or neither rises nor falls, runs from 1/16 px/frame on; others jump while
// they rise and fall while they fall.
BodyAct act_of(const Body& body);

}  // namespace talus
