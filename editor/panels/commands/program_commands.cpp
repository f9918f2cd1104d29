// The commands about the program itself: settings, layouts, other programs.
#include <algorithm>
#include <array>
#include <optional>

#include "command_table.h"
#include "panels/layout_presets.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

CommandRun open_program(ProgramId id) {
  return [id](S, A, U ui) { ui.ask(request::OpenProgram{id}); };
}

// A column for which there is no room takes the place of the other one.
CommandRun show_or_hide_column(bool WindowView::*open, bool WindowView::*shown, TabPlace place) {
  return [=](S, A, U ui) {
    WindowView& window = ui.view.window;
    window.*open = !(window.*shown);
    if (window.*open) window.first = place;
  };
}

// The commands go on from the size that is shown, which may be the automatic one.
constexpr std::array<double, 5> kTextSizes = {1, 1.25, 1.5, 2, 3};
enum class TextStep { smaller, larger };

std::optional<double> next_text_size(TextStep step, const Ui& ui) {
  const double now = ui.scale;
  if (step == TextStep::larger) {
    const auto next = std::upper_bound(kTextSizes.begin(), kTextSizes.end(), now);
    return next == kTextSizes.end() ? std::nullopt : std::optional(*next);
  }
  const auto next = std::lower_bound(kTextSizes.begin(), kTextSizes.end(), now);
  return next == kTextSizes.begin() ? std::nullopt : std::optional(*(next - 1));
}
CommandRun step_text(TextStep step) {
  return [step](S, A, U ui) {
    if (const auto size = next_text_size(step, ui)) ui.view.window.ui_scale = *size;
  };
}
CommandTest can_step_text(TextStep step) {
  return [step](S, const Ui& ui) { return next_text_size(step, ui).has_value(); };
}

std::vector<Command> settings_commands() {
  return {
      {.id = "edit/settings",
       .label = "Settings...",
       .help = "Theme, size, colours, other programs and keys.",
       .key = ctrl(','),
       .menu = menus::kEditSettings,
       .run = toggle<&View::window, &WindowView::settings_open>,
       .checked = is_on<&View::window, &WindowView::settings_open>,
       .words = "preferences options configuration font scale theme"},
      {.id = "edit/keys",
       .label = "Change keys...",
       .help = "Gives commands other keys.",
       .key = ctrl_shift('k'),
       .menu = menus::kEditSettings,
       .run = [](S, A, U ui) { ui.view.commands.keys_open = true; },
       .words = "shortcuts bindings rebind hotkeys keyboard"},
      {.id = "view/larger_text",
       .label = "Larger text",
       .help = "Makes text and controls larger.",
       .run = step_text(TextStep::larger),
       .enabled = can_step_text(TextStep::larger),
       .words = "size of text scale zoom font bigger interface controls"},
      {.id = "view/smaller_text",
       .label = "Smaller text",
       .help = "Makes text and controls smaller.",
       .run = step_text(TextStep::smaller),
       .enabled = can_step_text(TextStep::smaller),
       .words = "size of text scale zoom font interface controls"},
      {.id = "view/light_theme",
       .label = "Light theme",
       .help = "Dark text on light panels; art stays on dark ground.",
       .key = ctrl_shift('h'),
       .menu = menus::kViewLooks,
       .run =
           [](S, A, U ui) {
             ThemeKind& theme = ui.view.preferences.theme;
             theme = theme == ThemeKind::light ? ThemeKind::dark : ThemeKind::light;
           },
       .checked = [](S, const Ui& ui) { return ui.view.preferences.theme == ThemeKind::light; }},
      {.id = "view/safe_colours",
       .label = "Colours for colour-blind people",
       .help = "Draws the overlays in colours that colour-blind people can tell apart.",
       .key = ctrl_shift('b'),
       .menu = menus::kViewLooks,
       .run =
           [](S s, A actions, U) {
             const bool safe = s.choices().overlay_palette == OverlayPalette::colour_blind;
             actions.push_back(
                 action::SetOverlayPalette{safe ? OverlayPalette::standard : OverlayPalette::colour_blind});
           },
       .checked = [](S s, const Ui&) { return s.choices().overlay_palette == OverlayPalette::colour_blind; }},
      {.id = "view/metrics",
       .label = "Times of the window",
       .help = "Shows what frames of the window and steps of the simulation cost.",
       .key = ctrl_shift('u'),
       .menu = menus::kViewLooks,
       .run = toggle<&View::window, &WindowView::metrics_open>,
       .checked = is_on<&View::window, &WindowView::metrics_open>,
       .words = "metrics fps performance budget profiler statistics"},
  };
}

std::vector<Command> layout_commands() {
  std::vector<Command> all;
  int key = '1';
  for (const LayoutPreset& preset : layout_presets())
    all.push_back({.id = layout_command(preset),
                   .label = std::string(preset.label),
                   .help = std::string(preset.help),
                   .key = ctrl_shift(key++),
                   .menu = menus::kViewLayouts,
                   .run = [&preset](S, A, U ui) { show_layout(preset, ui.view); },
                   .checked = [&preset](S, const Ui& ui) { return is_shown(preset, ui.view); },
                   .words = "layout arrange panels"});
  return all;
}

std::vector<Command> column_commands() {
  return {
      {.id = "view/layouts",
       .label = "Layouts...",
       .help = "Saves how the window is arranged, and goes back to what was saved.",
       .key = ctrl_shift('4'),
       .menu = menus::kViewLayouts,
       .run = toggle<&View::window, &WindowView::layouts_open>,
       .checked = is_on<&View::window, &WindowView::layouts_open>,
       .words = "arrange save workspace perspective"},
      {.id = "view/alone",
       .label = "Canvas alone",
       .help = "Hides every panel and bar, or brings them back.",
       .key = ctrl(' '),
       .menu = menus::kViewLayouts,
       .run = toggle<&View::window, &WindowView::alone>,
       .checked = is_on<&View::window, &WindowView::alone>,
       .words = "hide panels distraction"},
      {.id = "view/full_screen",
       .label = "Full screen",
       .help = "Lets the window fill the screen, or not.",
       .key = alt(kKeyEnter),
       .menu = menus::kViewLayouts,
       .run = toggle<&View::window, &WindowView::full_screen>,
       .checked = is_on<&View::window, &WindowView::full_screen>},
      {.id = "view/left_column",
       .label = "Left column",
       .help = "Shows or hides the sheet and what is below it.",
       .key = alt(','),
       .menu = menus::kViewLayouts,
       .run = show_or_hide_column(&WindowView::left_open, &WindowView::left_shown, TabPlace::left),
       .checked = is_on<&View::window, &WindowView::left_shown>},
      {.id = "view/right_column",
       .label = "Right column",
       .help = "Shows or hides the inspector and what is below it.",
       .key = alt('.'),
       .menu = menus::kViewLayouts,
       .run = show_or_hide_column(&WindowView::right_open, &WindowView::right_shown, TabPlace::right_top),
       .checked = is_on<&View::window, &WindowView::right_shown>},
  };
}

std::vector<Command> file_guard_commands() {
  return {
      {.id = "file/recover",
       .label = "Recover...",
       .help = "Offers the work that was saved automatically before the program was killed.",
       .key = ctrl_shift('y'),
       .menu = menus::kFileSave,
       .run = [](S, A, U ui) { ui.view.window.recovery_open = true; }},
      {.id = "program/tic80",
       .label = "Open in TIC-80",
       .help = "Saves the cart and opens it in TIC-80. A level that is not a cart gets a copy, which is "
               "written whenever the level is saved. TIC-80 then reads the file again.",
       .key = ctrl_shift('t'),
       .menu = menus::kFilePrograms,
       .run = open_program(ProgramId::tic80)},
      {.id = "program/love",
       .label = "Run in LÖVE",
       .help = "Saves the level, exports its first preset of a game for LÖVE and runs it. Without such a "
               "preset, runs the game whose main.lua is in the folder of the level, or else exports one "
               "into a folder of Talus.",
       .key = ctrl_shift('l'),
       .menu = menus::kFilePrograms,
       .run = open_program(ProgramId::love)},
      {.id = "program/tiled",
       .label = "Open in Tiled",
       .help = "Writes a copy of the level as a map of Tiled, and again whenever it is saved, and opens it "
               "there. What Tiled saves in it stays. Opened here, the copy is a level again.",
       .key = ctrl_shift('i'),
       .menu = menus::kFilePrograms,
       .run = open_program(ProgramId::tiled)},
  };
}

}  // namespace

std::vector<Command> program_commands() {
  return joined({file_guard_commands(), settings_commands(), layout_commands(), column_commands()});
}

}  // namespace talus
