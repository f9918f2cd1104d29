// Actions: playing the level, and moving in the recording.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include <talus/collision/geometry.h>
#include "sim/timeline.h"

namespace talus {

// What an edit does while there is a recording. Without a recording, an edit always starts anew.
struct EditRule {
  enum class Kind {
    go_on,       // go on from the shown frame on the edited level
    from_start,  // run the recorded input again on it from frame 0
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
struct ResetPlay {};  // a new branch from frame 0 of the current level; keeps running if it ran
struct SetSpeed {
  double factor = 1;  // kMinSpeed to kMaxSpeed; clamped
};
struct HoldMouse {  // the mouse over the play view, in level pixels; drags the chosen ball while down
  Vec2 position;
  bool down = false;
};
struct HoldKeys {  // the keys of the players that are held from now on
  bool left = false, right = false, jump = false;
  friend bool operator==(const HoldKeys&, const HoldKeys&) = default;
};
struct SelectBody {
  int id = 0;  // 0, or an unknown id: no body
};
struct SelectSpawn {  // chooses the body of a spawn of the level
  int spawn = 0;      // its index; an unknown one: no body
};
struct StepBack {};   // the frame before
struct SeekStart {};  // frame 0
struct SeekEnd {};    // the last recorded frame
struct SeekFrame {
  std::int64_t frame = 0;  // clamped to the recorded ones
};
struct SetMark {           // at a frame; renames a mark that is there
  std::int64_t frame = 0;  // clamped
  std::string name;
};
struct RemoveMark {
  std::int64_t frame = 0;  // does nothing if it has no mark
};
struct JumpToMark {
  bool forwards = true;  // to the next mark or the previous one; does nothing if there is none
};
struct TakeOver {};  // leaves the recording at the shown frame: the next steps go on from there
struct SwitchBranch {
  int branch = 0;  // id, here and below; does nothing for an unknown one
};
// May be the shown branch; the last branch is emptied. Asks first unless it is empty: see
// Session::question().
struct DropBranch {
  int branch = 0;
};
struct CompareBranch {  // shows it with the current branch
  int branch = 0;       // 0: no comparison
};
// Presses or releases a key in the steps to the frames first..last, and runs what follows again. Clamped.
struct SetInput {
  std::int64_t first = 1, last = 1;
  InputKey key = InputKey::left;
  bool on = true;
};
struct SetMouse {  // the place of the mouse in these steps, in the same way
  std::int64_t first = 1, last = 1;
  Vec2 position;  // px, in the level; finite
};
struct SetEditRule {
  EditRule rule;
};
struct Rerun {            // runs the recorded input on the current level
  std::int64_t from = 0;  // frame; clamped
};
struct CancelRerun {};  // the branch ends at the last frame that was run

}  // namespace action

// The actions that RunHandler carries out.
using RunAction =
    std::variant<action::Play, action::Pause, action::TogglePlay, action::StepFrame, action::ResetPlay,
                 action::SetSpeed, action::HoldMouse, action::HoldKeys, action::SelectBody,
                 action::SelectSpawn, action::StepBack, action::SeekStart, action::SeekEnd, action::SeekFrame,
                 action::SetMark, action::RemoveMark, action::JumpToMark, action::TakeOver,
                 action::SwitchBranch, action::DropBranch, action::CompareBranch, action::SetInput,
                 action::SetMouse, action::SetEditRule, action::Rerun, action::CancelRerun>;

}  // namespace talus
