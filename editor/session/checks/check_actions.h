// Actions: what is likely wrong in the level, and where a player of it gets to.
#pragma once

#include <variant>

#include "lint/lint.h"

namespace talus {
namespace action {

struct SetLintOptions {
  LintOptions options;  // clamped
};
struct FindReach {};    // of the level as it is now; what was found before is forgotten
struct CancelReach {};  // keeps what has been found
struct ShowWay {        // plays the way to a reached cell as a new branch; to another one nothing happens
  Cell cell;
};

}  // namespace action

// What CheckHandler carries out.
using CheckAction =
    std::variant<action::SetLintOptions, action::FindReach, action::CancelReach, action::ShowWay>;

}  // namespace talus
