// The commands about the program itself: settings, layouts, other programs.
#include <algorithm>
#include <array>
#include <optional>

#include "command_table.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

// A way to share the window out; sizes in fractions as in Layout.
struct ReadyLayout {
  Layout layout;
  CanvasMode canvas;
  bool enlarged_pixels;  // above the map or the play view
  Focus focus;
  bool dock_open;
  std::string_view tab;  // id of the panel that comes to the front
};

constexpr Layout ready_sizes(double right, double pixels = Layout().pixels) {
  Layout layout;
  layout.right = right;
  layout.pixels = pixels;
  return layout;
}
constexpr ReadyLayout kDrawLayout{ready_sizes(0.27, 0.42), CanvasMode::map, true,
                                  Focus::sprites,          false,           "problems"};
constexpr ReadyLayout kPlayLayout{ready_sizes(0.27), CanvasMode::play, false, Focus::map, false, "tuning"};
constexpr ReadyLayout kDebugLayout{Layout(), CanvasMode::play, false, Focus::map, true, "inspector"};

template <const ReadyLayout& ready>
void take_layout(S, A, U ui) {
  ui.view.layout = ready.layout;
  ui.view.canvas = ready.canvas;
  ui.view.pixels.enlarged = ready.enlarged_pixels;
  ui.view.focus = ready.focus;
  ui.view.dock_open = ready.dock_open;
  ui.view.wants_tab = std::string(ready.tab);
}

template <ProgramId id>
void open_program(S, A, U ui) {
  ui.view.program.wanted_program = id;
}

template <bool ProgramView::*window>
void toggle_window(S, A, U ui) {
  ui.view.program.*window = !(ui.view.program.*window);
}
template <bool ProgramView::*window>
bool has_window(S, const Ui& ui) {
  return ui.view.program.*window;
}

// From the size that is shown, which may be the automatic one.
constexpr std::array<double, 5> kTextSizes = {1, 1.25, 1.5, 2, 3};
enum class TextStep { smaller, larger };

template <TextStep step>
std::optional<double> next_text_size(const Ui& ui) {
  const double now = ui.scale;
  if (step == TextStep::larger) {
    const auto next = std::upper_bound(kTextSizes.begin(), kTextSizes.end(), now);
    return next == kTextSizes.end() ? std::nullopt : std::optional(*next);
  }
  const auto next = std::lower_bound(kTextSizes.begin(), kTextSizes.end(), now);
  return next == kTextSizes.begin() ? std::nullopt : std::optional(*(next - 1));
}
template <TextStep step>
void step_text(S, A, U ui) {
  if (const auto size = next_text_size<step>(ui)) ui.view.ui_scale = *size;
}
template <TextStep step>
bool can_step_text(S, const Ui& ui) {
  return next_text_size<step>(ui).has_value();
}

std::vector<Command> settings_commands() {
  return {
      also_called(
          "preferences options configuration font scale theme",
          toggle("edit/settings", ctrl(','), "Settings...", "Theme, size, colours, other programs and keys.",
                 toggle_window<&ProgramView::settings_open>, has_window<&ProgramView::settings_open>)),
      also_called("shortcuts bindings rebind hotkeys keyboard",
                  command("edit/keys", ctrl_shift('k'), "Change keys...", "Gives commands other keys.",
                          [](S, A, U ui) { ui.view.program.keys_open = true; })),
      also_called("size of text scale zoom font bigger interface controls",
                  command("view/larger_text", {}, "Larger text", "Makes text and controls larger.",
                          step_text<TextStep::larger>, can_step_text<TextStep::larger>)),
      also_called("size of text scale zoom font interface controls",
                  command("view/smaller_text", {}, "Smaller text", "Makes text and controls smaller.",
                          step_text<TextStep::smaller>, can_step_text<TextStep::smaller>)),
      toggle(
          "view/light_theme", ctrl_shift('h'), "Light theme",
          "Dark text on light panels; art stays on dark ground.",
          [](S, A, U ui) {
            ThemeKind& theme = ui.view.preferences.theme;
            theme = theme == ThemeKind::light ? ThemeKind::dark : ThemeKind::light;
          },
          [](S, const Ui& ui) { return ui.view.preferences.theme == ThemeKind::light; }),
      toggle(
          "view/safe_colours", ctrl_shift('b'), "Colours for colour-blind eyes",
          "Draws the overlays in colours that stay apart without red, green or blue.",
          [](S s, A actions, U) {
            const bool safe = s.choices().overlay_palette == OverlayPalette::colour_blind;
            actions.push_back(
                action::SetOverlayPalette{safe ? OverlayPalette::standard : OverlayPalette::colour_blind});
          },
          [](S s, const Ui&) { return s.choices().overlay_palette == OverlayPalette::colour_blind; }),
      also_called("metrics fps performance budget profiler statistics",
                  toggle("view/metrics", ctrl_shift('u'), "Times of the window",
                         "Shows what frames of the window and steps of the simulation cost.",
                         toggle_window<&ProgramView::metrics_open>, has_window<&ProgramView::metrics_open>)),
  };
}

std::vector<Command> layout_commands() {
  return {
      command("view/layout_draw", ctrl_shift('1'), "Layout to draw",
              "Much room for the sheet, the pixels and the map.", take_layout<kDrawLayout>),
      command("view/layout_play", ctrl_shift('2'), "Layout to play",
              "Much room for the play view, and the tuning.", take_layout<kPlayLayout>),
      command("view/layout_debug", ctrl_shift('3'), "Layout to debug",
              "The play view with the inspector and the debugger's panels.", take_layout<kDebugLayout>),
  };
}

std::vector<Command> file_guard_commands() {
  return {
      command("file/recover", ctrl_shift('y'), "Recover...",
              "Offers what was saved by itself before the program was killed.",
              [](S, A, U ui) { ui.view.program.recovery_open = true; }),
      command(
          "program/tic80", ctrl_shift('t'), "Open in TIC-80",
          "Saves the cart and opens it in TIC-80; of a level that is no cart, a copy, which is written with "
          "it whenever it is saved. TIC-80 reads either again then.",
          open_program<ProgramId::tic80>),
      command("program/love", ctrl_shift('l'), "Run in LÖVE",
              "Saves the level, exports its first preset of a game for LÖVE and runs that; without such a "
              "preset, "
              "what is in the folder of the level.",
              open_program<ProgramId::love>),
      command("program/tiled", ctrl_shift('i'), "Open in Tiled",
              "Writes a copy of the level as a map of Tiled, and again whenever it is saved, and opens it "
              "there. What Tiled saves in it stays. Opened here, the copy is a level again.",
              open_program<ProgramId::tiled>),
  };
}

}  // namespace

std::vector<Command> program_commands() {
  return joined({file_guard_commands(), settings_commands(), layout_commands()});
}

}  // namespace talus
