// A branch of a timeline: what was played of a level from frame 0 on, with everything that influenced it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../level/recording.h"
#include "keyframes.h"
#include "scene_cache.h"
#include "shared_log.h"

namespace talus {

// From its first frame on, the level was this version. The state at that frame follows from the one after the
// step: see edited_state() in runner.h.
struct Chapter {
  std::int64_t first = 0;  // 0 only for the first chapter
  VersionPtr version;
  bool kept_bodies = false;  // the edit neither added nor removed a body
  std::size_t bytes = 0;     // of memory that the version takes besides the chapter before; 0: not counted
};

// The kind of change that made a draft. The next change of the same kind re-runs the draft in place (see
// Timeline).
enum class Draft : std::uint8_t { none, level, input };

// Branches share the frames before the one at which they parted, so a copy is cheap.
struct Branch {
  int id = 0;             // from 1, never used twice
  int parent = 0;         // id of the branch that it left, which may be gone; 0: it left no branch
  std::int64_t fork = 0;  // the last frame that it shares with its parent; for a re-run from frame 0, frame 0
  int revision = 0;       // grows when frames that were run are run again in another way
  Draft draft = Draft::none;
  bool played_on = false;  // frames were played since it became a draft
  int compared = 0;        // id of the branch that it is shown with; 0: no branch

  LoneBodyPtr alone;                  // the body that plays alone; null: the bodies of the level play
  std::vector<Chapter> chapters;      // by first frame; at least one
  SharedLog<Input> inputs;            // of the steps that lead to frames 1, 2...
  SharedLog<std::uint64_t> hashes;    // of frames 0, 1... up to the last one that was run; never empty
  SharedLog<std::uint64_t> expected;  // the hashes of a recording that it came from; empty: no recording
  Keyframes keyframes;
  std::vector<Mark> marks;  // by frame

  std::int64_t last_frame() const { return static_cast<std::int64_t>(inputs.size()); }
  // The last frame that was run.
  std::int64_t run_frame() const { return static_cast<std::int64_t>(hashes.size()) - 1; }
  bool behind() const { return run_frame() < last_frame(); }  // whether some of its input is still to be run

  const Input& input(std::int64_t frame) const { return inputs[static_cast<std::size_t>(frame - 1)]; }
  // Index of the chapter that the step after `frame` belongs to.
  std::size_t chapter_at(std::int64_t frame) const {
    const auto next = std::upper_bound(chapters.begin() + 1, chapters.end(), frame,
                                       [](std::int64_t f, const Chapter& s) { return f < s.first; });
    return static_cast<std::size_t>(next - chapters.begin()) - 1;
  }
  // The level at that frame.
  const VersionPtr& version_at(std::int64_t frame) const { return chapters[chapter_at(frame)].version; }
};

}  // namespace talus
