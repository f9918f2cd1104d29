// Recorded input as JSON lines: {"frame":8,"mouse":[x,y],"down":true}.
#pragma once

#include <cstdint>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "formats/format.h"
#include "sim/state.h"

namespace talus {

// What the input is from a frame on.
struct TimedInput {
  std::int64_t frame = 1;  // the first step that it is applied to; from 1
  Input input;
};

// Reads the lines in order; a key that a line leaves out keeps its value. Frames must not go backwards.
// Errors name the line.
tl::expected<std::vector<TimedInput>, FormatError> read_input(std::string_view text);

// Plays them back: call at() with the frames 1, 2, 3...
class InputPlayer {
 public:
  explicit InputPlayer(std::vector<TimedInput> inputs) : inputs_(std::move(inputs)) {}
  const Input& at(std::int64_t frame);

 private:
  std::vector<TimedInput> inputs_;
  std::size_t next_ = 0;
  Input current_;
};

}  // namespace talus
