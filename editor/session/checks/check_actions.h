// Actions: likely problems of the level, where a player gets to, and whether bodies move as the ground says.
#pragma once

#include <variant>

#include "level/lint/lint.h"

namespace talus {
namespace action {

struct SetLintOptions {
  LintOptions options;  // clamped
};
struct FindReach {};    // in the current level; the last result is forgotten
struct CancelReach {};  // keeps the result so far
struct ShowWay {        // plays the way to a reached cell as a new branch; does nothing for another cell
  Cell cell;
};
struct Prove {  // the current level, and after each change what the change may matter to
  Cell near;    // places near this cell are proved first
};
struct CancelProof {};    // keeps what is found so far
struct PlayFinding {      // plays what the proof found as a new branch, and shows its frame
  std::size_t index = 0;  // in the proof's findings; an unknown one does nothing
};

}  // namespace action

// The actions that CheckHandler carries out.
using CheckAction = std::variant<action::SetLintOptions, action::FindReach, action::CancelReach,
                                 action::ShowWay, action::Prove, action::CancelProof, action::PlayFinding>;

}  // namespace talus
