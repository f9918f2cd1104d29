// Plays a body alone in the ground of a level: see LoneBody in level/recording.h.
#pragma once

#include <talus/level/limits.h>
#include <talus/sim/state.h>
#include "../level/recording.h"

namespace talus {

// BodyOrigin::spawn of such a body: no level has so many.
inline constexpr int kLoneSpawn = static_cast<int>(kMaxSpawns);

// The same scene with this body as its only one.
Scene scene_for(const LoneBody& body, Scene scene);

// The state of frame 0. scene: of scene_for(*alone, ...), or of a level if `alone` is null.
State start_state(const Scene& scene, const LoneBody* alone);

}  // namespace talus
