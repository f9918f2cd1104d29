// A branch of a timeline: one run of a level from frame 0, with everything that influenced it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../level/recording.h"
#include "keyframes.h"
#include "scene_cache.h"
#include "shared_log.h"

namespace talus {

// From its first frame on, the level was this version. What the state is there follows from the one that the
// step to that frame led to: see edited_state() in runner.h.
struct Chapter {
  std::int64_t first = 0;  // 0 for the first one alone
  VersionPtr version;
  bool kept_bodies = false;  // the edit neither added a body nor took one away
  std::size_t bytes = 0;     // of memory that the version takes besides the chapter before; 0: not reckoned
};

// By what a branch was made that the next change of the same kind runs again in place (see Timeline).
enum class Draft : std::uint8_t { none, level, input };

// Branches share what is before the frame at which they parted, so a copy is cheap.
struct Branch {
  int id = 0;             // from 1, never used twice
  int parent = 0;         // id of the branch that it left, which may be gone; 0: none
  std::int64_t fork = 0;  // the last frame that it has from its parent; of a re-run from frame 0, that frame
  int revision = 0;       // grows when frames that have been run are run again in another way
  Draft draft = Draft::none;
  bool played_on = false;  // frames were played since it became a draft
  int compared = 0;        // id of the branch that it is shown with; 0: none

  std::vector<Chapter> chapters;      // by first frame; at least one
  SharedLog<Input> inputs;            // of the steps that lead to the frames 1, 2...
  SharedLog<std::uint64_t> hashes;    // of the frames 0, 1... as far as they have been run; never empty
  SharedLog<std::uint64_t> expected;  // hashes that came with a recording; empty: none
  Keyframes keyframes;
  std::vector<Mark> marks;  // by frame

  std::int64_t last_frame() const { return static_cast<std::int64_t>(inputs.size()); }
  std::int64_t run_frame() const { return static_cast<std::int64_t>(hashes.size()) - 1; }  // run up to here
  bool behind() const { return run_frame() < last_frame(); }  // some of its input is still to be run

  const Input& input(std::int64_t frame) const { return inputs[static_cast<std::size_t>(frame - 1)]; }
  // The number of the chapter that the step after `frame` belongs to.
  std::size_t chapter_at(std::int64_t frame) const {
    const auto next = std::upper_bound(chapters.begin() + 1, chapters.end(), frame,
                                       [](std::int64_t f, const Chapter& s) { return f < s.first; });
    return static_cast<std::size_t>(next - chapters.begin()) - 1;
  }
  // The level as it was there.
  const VersionPtr& version_at(std::int64_t frame) const { return chapters[chapter_at(frame)].version; }
};

}  // namespace talus
