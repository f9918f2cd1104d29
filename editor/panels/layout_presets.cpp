#include "layout_presets.h"

#include "panels/panel_ids.h"

namespace talus {

std::span<const LayoutPreset> layout_presets() {
  static const std::vector<LayoutPreset> kPresets = {
      {"draw",
       "Draw",
       "The sheet and its tools beside the level.",
       true,
       true,
       true,
       false,
       {panel_id::kInspector, panel_id::kLayers}},
      {"play",
       "Play",
       "The level fills the window, with the tuning beside it.",
       false,
       true,
       false,
       false,
       {panel_id::kTuning}},
      {"debug",
       "Debug",
       "Why the chosen body moved as it did, and the recorded input below.",
       false,
       true,
       true,
       true,
       {panel_id::kWhy, panel_id::kProblems, panel_id::kInputRoll}}};
  return kPresets;
}

std::string layout_command(const LayoutPreset& preset) { return "view/layout_" + std::string(preset.key); }

void show_layout(const LayoutPreset& preset, View& view) {
  WindowView& window = view.window;
  window.alone = false;
  window.left_open = preset.left;
  window.right_open = preset.right;
  window.right_low_open = preset.right_low;
  window.first = preset.left ? TabPlace::left : TabPlace::right_top;
  window.dock_open = preset.dock;
  window.focus = Focus::map;
  view.canvas.mode = CanvasMode::play;
  for (const std::string_view tab : preset.tabs) {
    reopen_tab(window, tab);
    window.wanted_tabs.emplace_back(tab);
  }
  view.requests.ask(request::KeepZoom{preset.dock});
}

bool is_shown(const LayoutPreset& preset, const View& view) {
  const WindowView& window = view.window;
  return !window.alone && window.left_open == preset.left && window.right_open == preset.right &&
         window.right_low_open == preset.right_low && window.dock_open == preset.dock;
}

}  // namespace talus
