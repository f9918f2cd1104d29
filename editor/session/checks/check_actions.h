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
struct Prove {};        // the current level; the last proof stays until the new one is there
struct CancelProof {};  // keeps the last proof

}  // namespace action

// The actions that CheckHandler carries out.
using CheckAction = std::variant<action::SetLintOptions, action::FindReach, action::CancelReach,
                                 action::ShowWay, action::Prove, action::CancelProof>;

}  // namespace talus
