// The commands of the debugger: along the timeline, to stops, and through the stages of a step.
#include <algorithm>

#include "command_table.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool in_past(S session, const Ui&) { return session.timeline().in_past(); }
bool has_frames(S session, const Ui&) { return session.timeline().last_frame() > 0; }
bool after_start(S session, const Ui&) { return session.state().frame > 0; }
bool has_stops(S session, const Ui&) { return !session.debugger().stops().breakpoints().empty(); }
bool has_marks(S session, const Ui&) { return !session.timeline().current().marks.empty(); }
bool has_stages(S session, const Ui&) { return !session.stages().empty(); }

void toggle_mark(S session, A actions, U) {
  const std::int64_t frame = session.state().frame;
  const auto& marks = session.timeline().current().marks;
  const bool is_marked =
      std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.frame == frame; });
  if (is_marked) {
    actions.push_back(action::RemoveMark{frame});
  } else {
    actions.push_back(action::SetMark{frame, ""});
  }
}

template <bool forwards>
void jump_to_mark(S, A actions, U) {
  actions.push_back(action::JumpToMark{forwards});
}

template <int direction>
void change_stage(S session, A, U ui) {
  const int last = static_cast<int>(session.stages().size()) - 1;
  const int now = std::min(ui.view.stage, last);
  ui.view.stage = direction > 0 ? std::min(now + 1, last) : std::max(now - 1, -1);
}

std::vector<Command> timeline_commands() {
  return {
      repeating(command("timeline/back", shift(kKeyF10), "Step back one frame",
                        "Pauses and shows the frame before this one.", emit<action::StepBack>, after_start)),
      command("timeline/end", KeyChord{kKeyEnd}, "To the last frame", "Shows the last recorded frame.",
              emit<action::SeekEnd>, in_past),
      command("timeline/mark", ctrl('m'), "Mark this frame",
              "Sets a mark at the shown frame, or takes it away.", toggle_mark),
      command("timeline/next_mark", alt(kKeyRight), "Next mark", "Shows the next marked frame.",
              jump_to_mark<true>, has_marks),
      command("timeline/previous_mark", alt(kKeyLeft), "Previous mark",
              "Shows the marked frame before this one.", jump_to_mark<false>, has_marks),
      command(
          "file/save_recording", ctrl_shift('e'), "Save recording...",
          "Saves the run that is shown, with its level, as one file: a bug report that can be run again.",
          [](S, A, U ui) { ui.view.dialog = FileDialog::save_recording; }, has_frames),
      command(
          "timeline/rerun", ctrl_shift('r'), "Run again from frame 0",
          "Makes the whole run again with the recorded input, on the level as it is now.",
          [](S, A actions, U) { actions.push_back(action::Rerun{0}); }, after_start),
  };
}

std::vector<Command> stop_commands() {
  return {
      command(
          "stops/forwards", KeyChord{kKeyF9}, "Run to the next breakpoint",
          "Goes on, through what is recorded and beyond, until a breakpoint stops it.",
          [](S, A actions, U) { actions.push_back(action::RunToStop{SearchDirection::forwards}); },
          has_stops),
      command(
          "stops/back", shift(kKeyF9), "Run back to a breakpoint",
          "Shows the last frame before this one at which a breakpoint stops.",
          [](S, A actions, U) { actions.push_back(action::RunToStop{SearchDirection::backwards}); },
          has_stops),
      repeating(command("why/next", KeyChord{kKeyF11}, "Next stage of the step",
                        "Draws the next stage of the chosen body's step in the play view.", change_stage<1>,
                        has_stages)),
      repeating(command("why/before", shift(kKeyF11), "Stage before",
                        "Draws the stage before; before the first, none.", change_stage<-1>, has_stages)),
      toggle(
          "compare/split", KeyChord{kKeyF7}, "Two views",
          "Shows the other side of a comparison in a view of its own, instead of as ghosts.",
          [](S, A, U ui) { ui.view.split_compared = !ui.view.split_compared; },
          [](S, const Ui& ui) { return ui.view.split_compared; }),
      toggle(
          "view/debugger", KeyChord{kKeyF4}, "Debugger",
          "Shows the panels of the debugger: input, plots, breakpoints and comparison.",
          [](S, A, U ui) { ui.view.dock_open = !ui.view.dock_open; },
          [](S, const Ui& ui) { return ui.view.dock_open; }),
  };
}

}  // namespace

std::vector<Command> debug_commands() { return joined({timeline_commands(), stop_commands()}); }

}  // namespace talus
