// The commands of the debugger: along the timeline, to stops, and through the stages of a step.
#include <algorithm>

#include "command_table.h"
#include "debug/compare.h"
#include "panels/debugger/compare_choice.h"
#include "panels/debugger/frame_zoom.h"

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
  ui.view.wants_tab = "why";
  ui.view.stage = direction > 0 ? std::min(now + 1, last) : std::max(now - 1, -1);
}

template <int by>
void seek_by(S session, A actions, U) {
  actions.push_back(action::SeekFrame{session.state().frame + by});
}

template <int by>
void change_branch(S session, A actions, U) {
  const auto& branches = session.timeline().branches();
  const auto count = static_cast<int>(branches.size());
  int now = 0;
  while (branches[static_cast<std::size_t>(now)].id != session.timeline().current().id) ++now;
  actions.push_back(action::SwitchBranch{branches[static_cast<std::size_t>((now + by + count) % count)].id});
}
bool has_branches(S session, const Ui&) { return session.timeline().branches().size() > 1; }

void cancel(S session, A actions, U) {
  if (session.debugger().searching()) actions.push_back(action::CancelSearch{});
  if (session.timeline().behind()) actions.push_back(action::CancelRerun{});
  if (session.debugger().comparing_progress(session.timeline()))
    actions.push_back(action::CompareVariant{std::nullopt});
}

void next_edit_rule(S session, A actions, U) {
  using Kind = EditRule::Kind;
  const std::int64_t frame = session.state().frame;
  EditRule rule;
  std::string text = "Edits go on from the shown frame.";
  if (session.edit_rule().kind == Kind::go_on) {
    rule.kind = Kind::from_start;
    text = "Edits run the recording again from frame 0.";
  } else if (session.edit_rule().kind == Kind::from_start && frame > 0) {
    rule = {Kind::from_frame, frame};
    text = "Edits run the recording again from frame " + std::to_string(frame) + ".";
  }
  actions.push_back(action::SetEditRule{rule});
  actions.push_back(action::ShowMessage{text});
}

// Opens a panel of the debugger, and gives the keys to its field.
void type_into(std::string_view panel, std::string_view field, U ui) {
  ui.view.dock_open = true;
  ui.view.wants_tab = panel;
  ui.view.wants_text = field;
}

void switch_all_stops(S session, A actions, U) {
  const auto& all = session.debugger().stops().breakpoints();
  const bool any = std::any_of(all.begin(), all.end(), [](const Breakpoint& b) { return b.enabled; });
  for (Breakpoint breakpoint : all) {
    breakpoint.enabled = !any;
    actions.push_back(action::SetBreakpoint{breakpoint});
  }
}

void compare_with_next(S session, A actions, U) {
  const auto choices = compare_choices(session);
  const auto now = std::find(choices.begin(), choices.end(), compare_choice(session));
  const CompareChoice next = now + 1 < choices.end() ? *(now + 1) : choices.front();
  compare_with(next, actions);
  const bool none = next == choices.front();
  actions.push_back(
      action::ShowMessage{none ? "Compared with nothing." : "Compared with " + next.label + "."});
}
bool has_other(S session, const Ui&) { return is_compared(session); }

std::vector<Command> seek_commands() {
  return {
      command("timeline/start", KeyChord{kKeyHome}, "To the first frame",
              "Shows frame 0 of what is recorded.", emit<action::SeekStart>, after_start),
      command("timeline/end", KeyChord{kKeyEnd}, "To the last frame", "Shows the last recorded frame.",
              emit<action::SeekEnd>, in_past),
      repeating(command("timeline/back", shift(kKeyF10), "Step back one frame",
                        "Pauses and shows the frame before this one.", emit<action::StepBack>, after_start)),
      repeating(command("timeline/back_10", ctrl(kKeyLeft), "Back 10 frames",
                        "Pauses and shows the frame 10 before this one.", seek_by<-10>, after_start)),
      repeating(command("timeline/on_10", ctrl(kKeyRight), "On 10 frames",
                        "Pauses and shows the recorded frame 10 after this one.", seek_by<10>, in_past)),
      command(
          "timeline/go_to", ctrl(kKeyF10), "Go to frame...", "Shows the frame whose number is typed.",
          [](S, A, U ui) { ui.view.wants_text = "transport/frame"; }, has_frames),
      also_called("bookmark", command("timeline/mark", ctrl('m'), "Mark this frame",
                                      "Sets a mark at the shown frame, or takes it away.", toggle_mark)),
      command("timeline/next_mark", alt(kKeyRight), "Next mark", "Shows the next marked frame.",
              jump_to_mark<true>, has_marks),
      command("timeline/previous_mark", alt(kKeyLeft), "Previous mark",
              "Shows the marked frame before this one.", jump_to_mark<false>, has_marks),
  };
}

template <int steps>
void zoom_timeline(S session, A, U ui) {
  zoom_frames(ui.view.debugger.frames, static_cast<double>(session.state().frame), steps,
              session.timeline().last_frame());
}

std::vector<Command> frame_zoom_commands() {
  return {
      repeating(command("timeline/zoom_in", alt('='), "Zoom the timeline in",
                        "Shows fewer frames in the timeline and the plots; the wheel does it at the mouse.",
                        zoom_timeline<3>, has_frames)),
      repeating(command("timeline/zoom_out", alt('-'), "Zoom the timeline out",
                        "Shows more frames in the timeline and the plots; the wheel does it at the mouse.",
                        zoom_timeline<-3>, has_frames)),
      command(
          "timeline/fit", alt('0'), "Fit the timeline", "Shows all frames in the timeline and the plots.",
          [](S, A, U ui) { ui.view.debugger.frames = {}; },
          [](S, const Ui& ui) { return ui.view.debugger.frames != FrameZoom{}; }),
  };
}

std::vector<Command> branch_commands() {
  return {
      command("timeline/fork", ctrl('b'), "New branch from here",
              "Leaves the recording at the shown frame: what is played next goes on from there.",
              emit<action::TakeOver>, in_past),
      command("timeline/next_branch", alt(kKeyDown), "Next branch", "Shows the next run.", change_branch<1>,
              has_branches),
      command("timeline/previous_branch", alt(kKeyUp), "Previous branch", "Shows the run before.",
              change_branch<-1>, has_branches),
      command(
          "timeline/drop_branch", alt(kKeyDelete), "Drop this branch", "Forgets the run that is shown.",
          [](S session, A actions, U) {
            actions.push_back(action::DropBranch{session.timeline().current().id});
          },
          has_frames),
      command("timeline/edit_rule", alt('e'), "Next rule for edits",
              "What an edit does with the recording: goes on from the shown frame, or runs it again.",
              next_edit_rule),
      command(
          "timeline/rerun", ctrl_shift('r'), "Run again from frame 0",
          "Makes the whole run again with the recorded input, on the level as it is now.",
          [](S, A actions, U) { actions.push_back(action::Rerun{0}); }, after_start),
      command(
          "timeline/cancel", shift(kKeyF5), "Stop running again or searching",
          "The branch ends where it has come to; a search leaves the shown frame; a comparison whose other "
          "side is still being run ends.",
          cancel,
          [](S session, const Ui&) {
            return session.debugger().searching() || session.timeline().behind() ||
                   session.debugger().comparing_progress(session.timeline()).has_value();
          }),
      command(
          "file/save_recording", ctrl_shift('e'), "Save recording...",
          "Saves the run that is shown, with its level, as one file: a bug report that can be run again.",
          [](S, A, U ui) { ui.view.dialog = FileDialog::save_recording; }, has_frames),
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
      command("stops/new", ctrl(kKeyF9), "New breakpoint...", "Opens the breakpoints, to type a condition.",
              [](S, A, U ui) { type_into("stops", "stops/new", ui); }),
      command("stops/switch_all", ctrl_shift(kKeyF9), "Breakpoints off or on",
              "Switches all breakpoints off, or, when all are off, on.", switch_all_stops, has_stops),
      repeating(command("why/next", KeyChord{kKeyF11}, "Next stage of the step",
                        "Draws the next stage of the chosen body's step in the play view.", change_stage<1>,
                        has_stages)),
      repeating(command("why/before", shift(kKeyF11), "Stage before",
                        "Draws the stage before; before the first, none.", change_stage<-1>, has_stages)),
  };
}

// Gives the keys to a control of a panel that is always there.
void choose_in(std::string_view panel, std::string_view control, U ui) {
  ui.view.wants_tab = panel;
  ui.view.wants_text = control;
}

void pick_cell(S, A actions, U ui) {
  type_into("stops", "", ui);
  bool& picks = ui.view.debugger.picks_cell;
  picks = !picks;
  if (picks) actions.push_back(action::ShowMessage{"Click a cell on the map or the play view; Esc: none."});
}

std::vector<Command> choice_commands() {
  return {
      command("stops/kind", alt('k'), "What to stop at...",
              "Opens the list of what a breakpoint can stop at; Tab goes on to its numbers.",
              [](S, A, U ui) { type_into("stops", "stops/kind", ui); }),
      command("stops/add", alt('a'), "Add the chosen breakpoint",
              "Adds a breakpoint of the kind and with the numbers that are chosen in its panel.",
              [](S, A, U ui) { type_into("stops", "stops/add", ui); }),
      toggle("stops/pick", alt('i'), "Pick a breakpoint's cell on the map",
             "The next click on the map or the play view chooses the cell that a breakpoint is about.",
             pick_cell, [](S, const Ui& ui) { return ui.view.debugger.picks_cell; }),
      command("tuning/solver", alt_shift('t'), "Choose the solver...", "Opens the list of solvers.",
              [](S, A, U ui) { choose_in("tuning", "tuning/solver", ui); }),
      also_called(
          "gravity friction physics speed",
          command("tuning/fields", alt('t'), "Change the tuning...",
                  "Gives the keys to the first number of the tuning; Tab goes to the next.",
                  [](S, A, U ui) { choose_in("tuning", "tuning/" + tuning_fields()[0].path(), ui); })),
  };
}

std::vector<Command> watch_commands() {
  return {
      toggle(
          "view/debugger", KeyChord{kKeyF4}, "Debugger",
          "Shows the panels of the debugger: input, plots, breakpoints and comparison.",
          [](S, A, U ui) { ui.view.dock_open = !ui.view.dock_open; },
          [](S, const Ui& ui) { return ui.view.dock_open; }),
      command("watch/new_watch", ctrl(kKeyF8), "Watch an expression...",
              "Opens the plots, to type an expression.",
              [](S, A, U ui) { type_into("watch", "watch/new", ui); }),
      toggle(
          "watch/choose_times", ctrl_shift(kKeyF8), "Plot the time of a step",
          "Plots how long the steps take.", [](S, A, U ui) { ui.view.shows_times = !ui.view.shows_times; },
          [](S, const Ui& ui) { return ui.view.shows_times; }),
      command(
          "compare/next", shift(kKeyF7), "Compare with the next",
          "The same input through exact, its single precision, bump and article, then the other branches, "
          "then nothing.",
          compare_with_next),
      toggle(
          "compare/split", KeyChord{kKeyF7}, "Two views",
          "Shows the other side of a comparison in a view of its own, instead of as ghosts.",
          [](S, A, U ui) { ui.view.split_compared = !ui.view.split_compared; },
          [](S, const Ui& ui) { return ui.view.split_compared; }),
      command(
          "compare/first", ctrl(kKeyF7), "First parting frame",
          "Shows the first frame in which a body is further than that from its other self.",
          [](S session, A actions, U) {
            actions.push_back(action::FindParting{session.debugger().parting()});
          },
          has_other),
      command(
          "compare/stop", ctrl_shift(kKeyF7), "Stop where they part",
          "Adds a breakpoint that stops a run where they part.",
          [](S session, A actions, U) {
            actions.push_back(
                action::SetBreakpoint{{.condition = parting_condition(session.debugger().parting())}});
          },
          has_other),
  };
}

}  // namespace

std::vector<Command> debug_commands() {
  return joined({seek_commands(), frame_zoom_commands(), branch_commands(), stop_commands(),
                 choice_commands(), watch_commands()});
}

}  // namespace talus
