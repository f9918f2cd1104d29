// Replays a collision scenario: a list of operations on a World, each answered by one line of JSON.
//
//   {"cell_size":64,"ops":[{"op":"add","item":1,"rect":[0,0,8,8]},{"op":"move","item":1,"goal":[5,0]}]}
//
// answers {"ok":true} and {"x":5,"y":0,"cols":[]}. The operations:
//   add {item, rect}, update {item, rect}, remove {item}, getRect {item},
//   move {item, goal, filter}, check {item, goal, filter},
//   queryRect {rect}, queryPoint {point},
//   querySegment {from, to}, querySegmentWithCoords {from, to}, toCell {point}
// An item is named by an integer, unique in the world. A rect is [x,y,w,h]; update keeps a size that is
// missing or null. A filter maps the other item's name to "touch", "cross", "slide", "bounce" or null, which
// ignores it, with "default" for the others; without a filter everything slides. What the world refuses, such
// as a size of zero, is answered by {"error":".."} in bump's words and changes nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include <talus/formats/format.h>

namespace talus {

// Limit for the cells and boxes that all operations of a scenario test together, see World::looks(). It takes
// some seconds.
inline constexpr std::int64_t kMaxReplayLooks = std::int64_t{1} << 24;

// Gets the answer to an operation, without a line break. False: no more are wanted, which is no error.
using TakeAnswer = std::function<bool(std::string_view line)>;

// Gives each answer when it is made: all of them could fill the memory. The error's place is the line of
// malformed JSON, or the number of the operation, from 1: "op 12"; the answers before it were given. The
// operation that leads beyond most_looks is answered, and is then an error.
FormatResult<void> replay_scenario(std::string_view json, const TakeAnswer& take,
                                   std::int64_t most_looks = kMaxReplayLooks);

}  // namespace talus
