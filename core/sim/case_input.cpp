#include "case_input.h"

#include <algorithm>

namespace talus {

Input case_input(std::span<const CaseInput> entries, std::int64_t frame) {
  const auto next = std::upper_bound(entries.begin(), entries.end(), frame,
                                     [](std::int64_t f, const CaseInput& entry) { return f < entry.frame; });
  if (next == entries.begin()) return {};
  RecordedInput held;
  static_cast<CaseInput&>(held) = *(next - 1);
  return input_of(held);
}

Input input_of(const RecordedInput& entry) {
  return {.mouse = entry.mouse,
          .mouse_down = entry.mouse_down,
          .left = entry.left,
          .right = entry.right,
          .jump = entry.jump,
          .grab = entry.grab};
}

Input added(const Input& of_case, const Input& live) {
  return {.mouse = of_case.mouse_down && !live.mouse_down ? of_case.mouse : live.mouse,
          .mouse_down = of_case.mouse_down || live.mouse_down,
          .left = of_case.left || live.left,
          .right = of_case.right || live.right,
          .jump = of_case.jump || live.jump,
          .grab = live.mouse_down ? live.grab : of_case.grab};
}

}  // namespace talus
