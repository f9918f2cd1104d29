#include "input_file.h"

#include "sim/case_input.h"

namespace talus {

const Input& InputPlayer::at(std::int64_t frame) {
  while (next_ < inputs_.size() && inputs_[next_].frame <= frame) current_ = input_of(inputs_[next_++]);
  return current_;
}

}  // namespace talus
