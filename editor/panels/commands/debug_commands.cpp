// The commands of the debugger: moving along the timeline, running to breakpoints, and showing the stages of
// a step.
#include <algorithm>

#include "command_table.h"
#include "debug/compare.h"
#include "panels/canvas/opening_area.h"
#include "panels/debugger/compare_choice.h"
#include "panels/debugger/frame_zoom.h"
#include "panels/debugger/typed_condition.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool in_past(S session, const Ui&) { return session.timeline().in_past(); }
bool has_frames(S session, const Ui&) { return session.timeline().last_frame() > 0; }
bool after_start(S session, const Ui&) { return session.state().frame > 0; }
bool has_breakpoints(S session, const Ui&) { return !session.debugger().breakpoints().all().empty(); }
bool has_breakpoints_or_typed_one(S session, const Ui& ui) {
  return has_breakpoints(session, ui) || is_condition(ui.view.debugger.new_condition);
}
bool has_marks(S session, const Ui&) { return !session.timeline().current().marks.empty(); }
bool has_stages(S session, const Ui&) { return !session.stages().empty(); }

// Who types a condition and then runs means that condition.
template <SearchDirection direction>
void run_to_breakpoint(S session, A actions, U ui) {
  const std::string& typed = ui.view.debugger.new_condition;
  if (is_condition(typed)) add_breakpoint(typed, session, actions);
  actions.push_back(action::RunToBreakpoint{direction});
}

// The chosen body, or the player.
const Body* body_in_question(S session) { return followed_body(session.state(), session.choices().body); }

void find_last_stop(S session, A actions, U ui) {
  const int body = body_in_question(session)->id;
  actions.push_back(action::SelectBody{body});
  actions.push_back(action::FindLastStop{body});
  ui.ask(request::ShowTab(panel_id::kWhy));
}

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

CommandRun jump_to_mark(bool forwards) {
  return [forwards](S, A actions, U) { actions.push_back(action::JumpToMark{forwards}); };
}

CommandRun change_stage(int direction) {
  return [direction](S session, A, U ui) {
    const int last = static_cast<int>(session.stages().size()) - 1;
    const int now = std::min(ui.view.debugger.stage, last);
    ui.ask(request::ShowTab(panel_id::kWhy));
    ui.view.debugger.stage = direction > 0 ? std::min(now + 1, last) : std::max(now - 1, -1);
  };
}

CommandRun seek_by(int by) {
  return [by](S session, A actions, U) { actions.push_back(action::SeekFrame{session.state().frame + by}); };
}

CommandRun change_branch(int by) {
  return [by](S session, A actions, U) {
    const auto& branches = session.timeline().branches();
    const auto count = static_cast<int>(branches.size());
    int now = 0;
    while (branches[static_cast<std::size_t>(now)].id != session.timeline().current().id) ++now;
    actions.push_back(
        action::SwitchBranch{branches[static_cast<std::size_t>((now + by + count) % count)].id});
  };
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

void switch_all_breakpoints(S session, A actions, U) {
  const auto& all = session.debugger().breakpoints().all();
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
      {.id = "timeline/start",
       .label = "To the first frame",
       .help = "Shows frame 0 of the recording.",
       .key = KeyChord{kKeyHome},
       .menu = menus::kTimelineSeek,
       .icon = Icon::first_frame,
       .run = emit<action::SeekStart>,
       .enabled = after_start},
      {.id = "timeline/end",
       .label = "To the last frame",
       .help = "Shows the last recorded frame.",
       .key = KeyChord{kKeyEnd},
       .menu = menus::kTimelineSeek,
       .icon = Icon::last_frame,
       .run = emit<action::SeekEnd>,
       .enabled = in_past},
      {.id = "timeline/back",
       .label = "Step back one frame",
       .help = "Pauses and shows the frame before this one.",
       .key = shift(kKeyF10),
       .menu = menus::kTimelineSeek,
       .icon = Icon::step_back,
       .run = emit<action::StepBack>,
       .enabled = after_start,
       .repeats = true},
      {.id = "timeline/back_10",
       .label = "Back 10 frames",
       .help = "Pauses and shows the frame 10 before this one.",
       .key = ctrl(kKeyLeft),
       .menu = menus::kTimelineSeek,
       .run = seek_by(-10),
       .enabled = after_start,
       .repeats = true},
      {.id = "timeline/on_10",
       .label = "On 10 frames",
       .help = "Pauses and shows the recorded frame 10 after this one.",
       .key = ctrl(kKeyRight),
       .menu = menus::kTimelineSeek,
       .run = seek_by(10),
       .enabled = in_past,
       .repeats = true},
      {.id = "timeline/go_to",
       .label = "Go to frame...",
       .help = "Shows the frame whose number is typed.",
       .key = ctrl(kKeyF10),
       .menu = menus::kTimelineSeek,
       .run = [](S, A, U ui) { ui.ask(request::FocusField("transport/frame")); },
       .enabled = has_frames},
      {.id = "timeline/mark",
       .label = "Mark this frame",
       .help = "Sets a mark at the shown frame, or removes it.",
       .key = ctrl('m'),
       .menu = menus::kTimelineMarks,
       .run = toggle_mark,
       .words = "bookmark"},
      {.id = "timeline/next_mark",
       .label = "Next mark",
       .help = "Shows the next marked frame.",
       .key = alt(kKeyRight),
       .menu = menus::kTimelineMarks,
       .run = jump_to_mark(true),
       .enabled = has_marks},
      {.id = "timeline/previous_mark",
       .label = "Previous mark",
       .help = "Shows the marked frame before this one.",
       .key = alt(kKeyLeft),
       .menu = menus::kTimelineMarks,
       .run = jump_to_mark(false),
       .enabled = has_marks},
  };
}

CommandRun zoom_timeline(float steps) {
  return [steps](S session, A, U ui) {
    zoom_frames(ui.view.debugger.frames, static_cast<double>(session.state().frame), steps,
                session.timeline().last_frame());
  };
}

std::vector<Command> frame_zoom_commands() {
  return {
      {.id = "timeline/zoom_in",
       .label = "Zoom the timeline in",
       .help = "Shows fewer frames in the timeline and the plots; the wheel zooms at the mouse.",
       .key = alt('='),
       .menu = menus::kTimelineZoom,
       .run = zoom_timeline(3),
       .enabled = has_frames,
       .repeats = true},
      {.id = "timeline/zoom_out",
       .label = "Zoom the timeline out",
       .help = "Shows more frames in the timeline and the plots; the wheel zooms at the mouse.",
       .key = alt('-'),
       .menu = menus::kTimelineZoom,
       .run = zoom_timeline(-3),
       .enabled = has_frames,
       .repeats = true},
      {.id = "timeline/fit",
       .label = "Fit the timeline",
       .help = "Shows all frames in the timeline and the plots.",
       .key = alt('0'),
       .menu = menus::kTimelineZoom,
       .run = [](S, A, U ui) { ui.view.debugger.frames = {}; },
       .enabled = [](S, const Ui& ui) { return ui.view.debugger.frames != FrameZoom{}; }},
  };
}

std::vector<Command> branch_commands() {
  return {
      {.id = "timeline/fork",
       .label = "New branch from here",
       .help = "Starts a new branch at the shown frame: playing goes on from there.",
       .key = ctrl('b'),
       .menu = menus::kBranches,
       .run = emit<action::TakeOver>,
       .enabled = in_past},
      {.id = "timeline/next_branch",
       .label = "Next branch",
       .help = "Shows the next branch.",
       .key = alt(kKeyDown),
       .menu = menus::kBranches,
       .run = change_branch(1),
       .enabled = has_branches},
      {.id = "timeline/previous_branch",
       .label = "Previous branch",
       .help = "Shows the previous branch.",
       .key = alt(kKeyUp),
       .menu = menus::kBranches,
       .run = change_branch(-1),
       .enabled = has_branches},
      {.id = "timeline/drop_branch",
       .label = "Drop this branch",
       .help = "Deletes the branch that is shown.",
       .key = alt(kKeyDelete),
       .menu = menus::kBranches,
       .run = [](S session, A actions,
                 U) { actions.push_back(action::DropBranch{session.timeline().current().id}); },
       .enabled = has_frames},
      {.id = "timeline/edit_rule",
       .label = "Next rule for edits",
       .help = "Chooses what an edit does with the recording: go on from the shown frame, or run it again.",
       .key = alt('e'),
       .run = next_edit_rule},
      {.id = "timeline/rerun",
       .label = "Run again from frame 0",
       .help = "Runs all of the recorded input again, on the level as it is now.",
       .key = ctrl_shift('r'),
       .menu = menus::kBranchesRerun,
       .run = [](S, A actions, U) { actions.push_back(action::Rerun{0}); },
       .enabled = after_start},
      {.id = "timeline/cancel",
       .label = "Stop a rerun or a search",
       .help = "A branch that is run again ends at the frame that it has reached; a search keeps the shown "
               "frame; a comparison that is still being run ends.",
       .key = shift(kKeyF5),
       .menu = menus::kBranchesRerun,
       .run = cancel,
       .enabled =
           [](S session, const Ui&) {
             return session.debugger().searching() || session.timeline().behind() ||
                    session.debugger().comparing_progress(session.timeline()).has_value();
           }},
      {.id = "file/save_recording",
       .label = "Save recording...",
       .help =
           "Saves the branch that is shown, with its level, as one file: a bug report that can be run again.",
       .key = ctrl_shift('e'),
       .menu = menus::kDebugRecording,
       .run = [](S, A, U ui) { ui.ask(request::ShowFileDialog{FileDialog::save_recording}); },
       .enabled = has_frames},
  };
}

std::vector<Command> breakpoint_commands() {
  return {
      {.id = "breakpoints/forwards",
       .label = "Run to the next breakpoint",
       .help = "Runs through the recording and beyond it, until a breakpoint stops it.",
       .key = KeyChord{kKeyF9},
       .menu = menus::kBreakpointsRun,
       .icon = Icon::run_on,
       .run = run_to_breakpoint<SearchDirection::forwards>,
       .enabled = has_breakpoints_or_typed_one},
      {.id = "breakpoints/back",
       .label = "Run back to a breakpoint",
       .help = "Shows the last frame before this one at which a breakpoint stops.",
       .key = shift(kKeyF9),
       .menu = menus::kBreakpointsRun,
       .icon = Icon::run_back,
       .run = run_to_breakpoint<SearchDirection::backwards>,
       .enabled = has_breakpoints_or_typed_one},
      {.id = "breakpoints/new",
       .label = "New breakpoint...",
       .help = "Opens the breakpoints, to type a condition.",
       .key = ctrl(kKeyF9),
       .menu = menus::kBreakpointsNew,
       .run = go_to_field(panel_id::kBreakpoints, "breakpoints/new", PanelIn::debugger)},
      {.id = "breakpoints/switch_all",
       .label = "Breakpoints off or on",
       .help = "Switches all breakpoints off or, if all are off, on.",
       .key = ctrl_shift(kKeyF9),
       .menu = menus::kBreakpointsSwitch,
       .run = switch_all_breakpoints,
       .enabled = has_breakpoints},
      {.id = "why/next",
       .label = "Next stage of the step",
       .help = "Draws the next stage of the chosen body's step in the play view.",
       .key = KeyChord{kKeyF11},
       .menu = menus::kDebugStages,
       .icon = Icon::step,
       .run = change_stage(1),
       .enabled = has_stages,
       .repeats = true},
      {.id = "why/last_stop",
       .label = "Last stop",
       .help = "Pauses, and goes back to the last frame in which something stopped the chosen body, or the "
               "player; Why says then what it was.",
       .menu = menus::kDebugStages,
       .run = find_last_stop,
       .enabled = [](S s, const Ui&) { return s.state().frame > 0 && body_in_question(s) != nullptr; },
       .words = "stuck blocked back"},
      {.id = "why/before",
       .label = "Previous stage",
       .help = "Draws the previous stage; at the first one, draws no stage any more.",
       .key = shift(kKeyF11),
       .menu = menus::kDebugStages,
       .icon = Icon::step_back,
       .run = change_stage(-1),
       .enabled = has_stages,
       .repeats = true},
  };
}

void pick_cell(S session, A actions, U ui) {
  go_to_field(panel_id::kBreakpoints, "", PanelIn::debugger)(session, actions, ui);
  bool& picks = ui.view.debugger.picks_cell;
  picks = !picks;
  if (picks)
    actions.push_back(action::ShowMessage{"Click a cell on the map or in the play view; Esc cancels."});
}

std::vector<Command> choice_commands() {
  return {
      {.id = "breakpoints/kind",
       .label = "Kind of breakpoint...",
       .help = "Opens the list of what a breakpoint can stop at; Tab goes to its numbers.",
       .key = alt('k'),
       .menu = menus::kBreakpointsNew,
       .run = go_to_field(panel_id::kBreakpoints, "breakpoints/kind", PanelIn::debugger)},
      {.id = "breakpoints/add",
       .label = "Add the chosen breakpoint",
       .help = "Adds a breakpoint of the kind and with the numbers that are chosen in its panel.",
       .key = alt('a'),
       .menu = menus::kBreakpointsNew,
       .run = go_to_field(panel_id::kBreakpoints, "breakpoints/add", PanelIn::debugger)},
      {.id = "breakpoints/pick",
       .label = "Pick a breakpoint's cell on the map",
       .help = "The next click on the map or the play view chooses the cell that a breakpoint is about.",
       .key = alt('i'),
       .menu = menus::kBreakpointsNew,
       .icon = Icon::pick,
       .run = pick_cell,
       .checked = is_on<&View::debugger, &DebuggerView::picks_cell>},
      {.id = "tuning/solver",
       .label = "Choose the solver...",
       .help = "Opens the list of solvers.",
       .key = alt_shift('t'),
       .menu = menus::kTuning,
       .run = go_to_field(panel_id::kTuning, "tuning/solver")},
      {.id = "tuning/fields",
       .label = "Change the tuning...",
       .help = "Goes to the first number of the tuning; Tab goes on to the next one.",
       .key = alt('t'),
       .menu = menus::kTuning,
       .run = go_to_field(panel_id::kTuning, "tuning/" + tuning_fields()[0].path()),
       .words = "gravity friction physics speed"},
  };
}

std::vector<Command> plot_commands() {
  return {
      {.id = "view/debugger",
       .label = "Debugger",
       .help = "Shows the panels of the debugger: input, plots, breakpoints and comparison.",
       .key = KeyChord{kKeyF4},
       .menu = menus::kDebugPanels,
       .run = toggle<&View::window, &WindowView::dock_open>,
       .checked = is_on<&View::window, &WindowView::dock_open>},
      {.id = "plots/new_plot",
       .label = "Plot an expression...",
       .help = "Opens the plots, to type an expression.",
       .key = ctrl(kKeyF8),
       .menu = menus::kPlots,
       .run = go_to_field(panel_id::kPlots, "plots/new", PanelIn::debugger)},
      {.id = "plots/choose_times",
       .label = "Plot the time of a step",
       .help = "Plots how long the steps take.",
       .key = ctrl_shift(kKeyF8),
       .menu = menus::kPlots,
       .run = toggle<&View::debugger, &DebuggerView::shows_times>,
       .checked = is_on<&View::debugger, &DebuggerView::shows_times>},
      {.id = "compare/next",
       .label = "Compare with the next",
       .help = "Compares with the same input in another solver: exact, exact in single precision, bump, "
               "article; then with the other branches; then with nothing.",
       .key = shift(kKeyF7),
       .menu = menus::kCompare,
       .run = compare_with_next},
      {.id = "compare/split",
       .label = "Two views",
       .help = "Shows the other side of a comparison in a view of its own, instead of as ghosts.",
       .key = KeyChord{kKeyF7},
       .menu = menus::kCompare,
       .icon = Icon::split,
       .run = toggle<&View::canvas, &CanvasesView::split_compared>,
       .checked = is_on<&View::canvas, &CanvasesView::split_compared>},
      {.id = "compare/first",
       .label = "First parting frame",
       .help = "Shows the first frame in which a body is further than the threshold from the same body on "
               "the other side.",
       .key = ctrl(kKeyF7),
       .menu = menus::kCompareParting,
       .run = [](S session, A actions,
                 U) { actions.push_back(action::FindParting{session.debugger().parting()}); },
       .enabled = has_other},
      {.id = "compare/stop",
       .label = "Stop where they part",
       .help = "Adds a breakpoint that stops where the two sides part.",
       .key = ctrl_shift(kKeyF7),
       .menu = menus::kCompareParting,
       .run =
           [](S session, A actions, U) {
             actions.push_back(
                 action::SetBreakpoint{{.condition = parting_condition(session.debugger().parting())}});
           },
       .enabled = has_other},
  };
}

}  // namespace

std::vector<Command> debug_commands() {
  return joined({seek_commands(), frame_zoom_commands(), branch_commands(), breakpoint_commands(),
                 choice_commands(), plot_commands()});
}

}  // namespace talus
