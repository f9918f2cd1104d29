#include "case_input.h"

#include <algorithm>

namespace talus {

Input case_input(std::span<const CaseInput> entries, std::int64_t frame) {
  const auto next = std::upper_bound(entries.begin(), entries.end(), frame,
                                     [](std::int64_t f, const CaseInput& entry) { return f < entry.frame; });
  if (next == entries.begin()) return {};
  const CaseInput& held = *(next - 1);
  return {.mouse = held.mouse,
          .mouse_down = held.mouse_down,
          .left = held.left,
          .right = held.right,
          .jump = held.jump};
}

Input added(const Input& of_case, const Input& live) {
  return {.mouse = of_case.mouse_down && !live.mouse_down ? of_case.mouse : live.mouse,
          .mouse_down = of_case.mouse_down || live.mouse_down,
          .left = of_case.left || live.left,
          .right = of_case.right || live.right,
          .jump = of_case.jump || live.jump};
}

}  // namespace talus
