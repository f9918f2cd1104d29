// The right answer in a native level, under its key "hard_case".
//
// clang-format off
//   "number"        of the list of hard cases, from 1. "title", "set_up", "right_answer": sentences.
//   "frames"        steps of a run, 1..1000000.
//   "input"         as `talus sim --input` reads it, as a list: {"frame", "mouse", "down", "keys"}.
//   "edits"         what is done to the bodies after the step to a frame, 0..frames, as a list by frame: {"frame",
//                   "remove": id of a body, 1..1000, "turn_round": true}. It has one of the two, or both. Checks make
//                   them, and so does the page of examples; where the level is played, its input alone counts.
//   "floor"         lists of points [x, y], left to right, each list a line; and {"arc": [x, y, radius, x0, x1]}
//                   (upper half), {"bowl": as "arc"} (lower half), {"sine": [x0, x1, middle, amplitude, wavelength,
//                   origin]}.
//   "checks"        objects with "measure", one of level/hard_case.h; "body" (1); "frame", or "frames": [a, b];
//                   "x", "y", "right", "bottom"; "bound" (0).
// Numbers are from -100000000 to 100000000. A floor has at most 256 lines and curves, and a case 256 checks
// and 256 edits.
// "translate" moves by whole tiles, right and down, as far as a level may be large.
// clang-format on
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <talus/formats/format.h>
#include "../../level/hard_case.h"

namespace talus {

// Returns the hard case in a level; nothing if the level is no hard case. Errors have their place by key.
FormatResult<std::optional<HardCase>> hard_case_of(const Level& level);

// Its keys in the order in which they are written.
std::span<const std::string_view> hard_case_keys();

}  // namespace talus
