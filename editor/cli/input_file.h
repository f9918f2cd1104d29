// Recorded input as JSON lines: {"frame":8,"mouse":[x,y],"down":true}; see formats/native/input_entry.h.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include <talus/sim/state.h>
#include "level/recording.h"

namespace talus {

// Plays back the result of read_input_lines (formats/native/input_entry.h): call at() with the frames 1, 2,
// 3...
class InputPlayer {
 public:
  explicit InputPlayer(std::vector<RecordedInput> inputs) : inputs_(std::move(inputs)) {}
  const Input& at(std::int64_t frame);

 private:
  std::vector<RecordedInput> inputs_;
  std::size_t next_ = 0;
  Input current_;
};

}  // namespace talus
