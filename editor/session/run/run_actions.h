// Actions: playing the level, and going about in what was recorded.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include <talus/collision/geometry.h>
#include "sim/timeline.h"

namespace talus {

// What an edit does while there is a recording. Whatever it says, an edit without one starts anew.
struct EditRule {
  enum class Kind {
    go_on,       // the shown frame goes on on the edited level
    from_start,  // the recorded input is run again on it from frame 0
    from_frame   // the same from `frame`, clamped to the recording
  };
  Kind kind = Kind::go_on;
  std::int64_t frame = 0;
  friend bool operator==(const EditRule&, const EditRule&) = default;
};

namespace action {

struct Play {};
struct Pause {};
struct TogglePlay {};
struct StepFrame {};  // pauses and makes one step, or shows the next recorded frame: see Session
struct ResetPlay {};  // a new run from frame 0 of the level as it is now; keeps running if it ran
struct SetSpeed {
  double factor = 1;  // kMinSpeed to kMaxSpeed; clamped
};
struct HoldMouse {  // the mouse over the play view, in level pixels; drags the chosen ball while down
  Vec2 position;
  bool down = false;
};
struct HoldKeys {  // the keys of the players, as they are held from now on
  bool left = false, right = false, jump = false;
};
struct SelectBody {
  int id = 0;  // 0, or the id of no body: none
};
struct SelectSpawn {  // the body of a spawn of the level
  int spawn = 0;      // its index; of none: no body
};
struct StepBack {};   // the frame before
struct SeekStart {};  // frame 0
struct SeekEnd {};    // the last frame recorded
struct SeekFrame {
  std::int64_t frame = 0;  // clamped to those recorded
};
struct SetMark {           // at a frame; renames the one that is there
  std::int64_t frame = 0;  // clamped
  std::string name;
};
struct RemoveMark {
  std::int64_t frame = 0;  // without a mark nothing happens
};
struct JumpToMark {
  bool forwards = true;  // to the next one or the one before; without one nothing happens
};
struct TakeOver {};  // leaves the recording at the shown frame: what is played next goes on from there
struct SwitchBranch {
  int branch = 0;  // id, here and below; of none: nothing happens
};
// The one shown too; of the last one, what it holds. Asks first, unless there is nothing in it: see
// Session::question().
struct DropBranch {
  int branch = 0;
};
struct CompareBranch {  // shows it with the current one
  int branch = 0;       // 0: none
};
// Presses or lets go a key in the steps to the frames first..last and runs what follows again. Clamped.
struct SetInput {
  std::int64_t first = 1, last = 1;
  InputKey key = InputKey::left;
  bool on = true;
};
struct SetMouse {  // where the mouse is in those steps, in the same way
  std::int64_t first = 1, last = 1;
  Vec2 position;  // px, in the level; finite
};
struct SetEditRule {
  EditRule rule;
};
struct Rerun {            // the recorded input on the level as it is now
  std::int64_t from = 0;  // frame; clamped
};
struct CancelRerun {};  // the branch ends where it has been run to

}  // namespace action

// What RunHandler carries out.
using RunAction =
    std::variant<action::Play, action::Pause, action::TogglePlay, action::StepFrame, action::ResetPlay,
                 action::SetSpeed, action::HoldMouse, action::HoldKeys, action::SelectBody,
                 action::SelectSpawn, action::StepBack, action::SeekStart, action::SeekEnd, action::SeekFrame,
                 action::SetMark, action::RemoveMark, action::JumpToMark, action::TakeOver,
                 action::SwitchBranch, action::DropBranch, action::CompareBranch, action::SetInput,
                 action::SetMouse, action::SetEditRule, action::Rerun, action::CancelRerun>;

}  // namespace talus
