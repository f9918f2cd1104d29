// Recording: a level, the input of each frame, the edits made meanwhile, and the hash of every frame, which
// shows whether a replay is the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "hard_case.h"
#include "level_version.h"

namespace talus {

// The input from a frame on. Frames count from 1, the first step.
struct RecordedInput : CaseInput {
  int grab = 0;  // as Input::grab
};

// The level became this version after the step of that frame, before the next step.
struct RecordedEdit {
  std::int64_t frame = 1;
  std::shared_ptr<const LevelVersion> version;  // never null
};

struct Mark {
  std::int64_t frame = 0;
  std::string name;  // for people; may be empty
  friend bool operator==(const Mark&, const Mark&) = default;
};

// A body that plays alone in the ground of a level, instead of the level's bodies.
struct LoneBody {
  Spawn spawn;             // its start
  bool stands = false;     // whether it stands on a floor at the start, as after a step
  double run_speed = 1.5;  // px/frame, of a player: PlayerTuning::run_speed instead of the level's
  friend bool operator==(const LoneBody&, const LoneBody&) = default;
};

struct Recording {
  Level level;                        // of frame 0
  std::optional<LoneBody> alone;      // nothing: the bodies of the level play
  std::int64_t frames = 0;            // steps
  std::vector<RecordedInput> input;   // by frame, each once, 1..frames; nothing is held before the first
  std::vector<RecordedEdit> edits;    // by frame, 1..frames; those of one frame in the order of the edits
  std::vector<Mark> marks;            // by frame, each once, 0..frames
  std::vector<std::uint64_t> hashes;  // frame_hash() of the frames 0..frames, after their edits; or empty
};

}  // namespace talus
