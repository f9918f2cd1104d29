// The choice in the input roll; for its panel, its commands and the canvas.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "panels/panel_ids.h"
#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct InputRow {
  InputKey key;
  std::string_view label;
};
inline constexpr std::array<InputRow, 4> kInputRows = {{{InputKey::left, "left"},
                                                        {InputKey::right, "right"},
                                                        {InputKey::jump, "jump"},
                                                        {InputKey::mouse, "mouse"}}};

struct FrameRange {
  std::int64_t first = 0, last = 0;
  bool has(std::int64_t frame) const { return frame >= first && frame <= last; }
};
// The shown frame, or the range of the roll's keys that ends there.
inline FrameRange chosen_frames(const Session& session, const View& view) {
  const std::int64_t shown = session.state().frame, from = view.debugger.input_range.value_or(shown);
  return {std::min(from, shown), std::max(from, shown)};
}

// Whether the roll is open, so that the canvas shows the recorded mouse, too.
inline bool shows_input_roll(const View& view) {
  return view.window.dock_open && std::find(view.window.tabs.begin(), view.window.tabs.end(),
                                            panel_id::kInputRoll) != view.window.tabs.end();
}

}  // namespace talus
