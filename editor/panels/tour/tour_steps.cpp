#include "tour_steps.h"

#include <cmath>

#include "panels/canvas/opening_area.h"
#include "panels/commands/commands.h"
#include "panels/panel_ids.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using Start = const TourStart&;

constexpr double kFarEnough = 16;  // px that the player has run

void show_play_view(S, A, Ui& ui) {
  if (ui.view.canvas.mode != CanvasMode::play) ui.view.canvas.mode = CanvasMode::both;
  ui.view.canvas.follow_body = true;
}

// Where a click chooses a body, also after the step that paints. None is chosen yet.
void take_up_hand(S session, A actions, Ui& ui) {
  show_play_view(session, actions, ui);
  ui.view.canvas.paint_in_play = false;
  find_command("play/no_body"_command).run(session, actions, ui);
}

void show_sheet(S, A, Ui& ui) { show_left_column(ui.view.window); }

void show_nothing(S, A, Ui&) {}

std::function<std::string_view(const Ui&)> at(std::string_view widget) {
  return [widget](const Ui&) { return widget; };
}

// Something has stopped the player on its way.
bool has_been_stopped(S session, const Ui&, Start start) {
  const Input& held = session.playback().input;
  const Body* player = followed_body(session.state(), 0);
  return session.playback().running && (held.left || held.right) && player != nullptr &&
         player->velocity.x == 0 && std::abs(player->box.x - start.player_x) >= kFarEnough;
}

bool is_paused(S session, const Ui&, Start) { return !session.playback().running; }

bool has_stepped(S session, const Ui&, Start start) {
  return !session.playback().running && session.state().frame > start.frame;
}

bool has_edited(S session, const Ui&, Start start) { return session.revision() != start.revision; }

bool has_switched(S session, const Ui&, Start start) { return session.choices().overlays != start.overlays; }

bool has_chosen(S session, const Ui&, Start) {
  return session.state().find(session.choices().body) != nullptr;
}

// A stage is drawn of the frame in which the player was stopped.
bool has_asked_why(S session, const Ui& ui, Start) {
  const auto& stop = session.debugger().stop();
  return ui.view.debugger.stage >= 0 && stop && stop->breakpoint == kStoppedBody;
}

bool has_gone_back(S session, const Ui&, Start start) { return session.state().frame < start.last_frame; }

// The button where the panel shows it, else its tab.
std::string_view last_stop_or_tab(const Ui& ui) {
  constexpr std::string_view kLastStop = "why/last_stop";
  return ui.widgets.find(kLastStop) != nullptr ? kLastStop : "tabs/why";
}

// The sheet until a tile is taken up.
std::string_view sheet_or_level(const Ui& ui) {
  if (ui.view.canvas.has_hand()) return "sheet/canvas";
  constexpr std::string_view kMap = "map/canvas";
  return ui.widgets.find(kMap) != nullptr ? kMap : "play/canvas";
}

void show_why(S, A, Ui& ui) {
  ui.view.debugger.stage = -1;
  ui.ask(request::ShowTab(panel_id::kWhy));
}

std::vector<TourStep> all_steps() {
  return {
      {"run", "Run",
       [](const Ui& ui) {
         return "Hold " + keys_of("player/right"_command, ui) +
                ": the player runs up the hill, until something stops it, though the hill looks smooth.";
       },
       show_play_view, at("play/canvas"), has_been_stopped},
      {"pause", "Stop the time",
       [](const Ui& ui) {
         return keys_of("play/toggle"_command, ui) + ", or this button, pauses the level.";
       },
       show_nothing, at("transport/play"), is_paused},
      {"step", "Go on frame by frame",
       [](const Ui& ui) {
         return keys_of("play/step"_command, ui) + ", or this button, makes one step: a 60th of a second.";
       },
       show_nothing, at("transport/step"), has_stepped},
      {"paint", "Paint",
       [](const Ui&) {
         return std::string(
             "Click a tile on the sheet at the left, and paint with it on the map. Undo takes it back.");
       },
       show_sheet, sheet_or_level, has_edited},
      {"overlays", "See the physics",
       [](const Ui&) {
         return std::string(
             "The eye has overlays that answer a question together. Choose \"What the article draws\".");
       },
       show_play_view, at("overlay/presets"), has_switched},
      {"choose", "Choose a body",
       [](const Ui&) { return std::string("Click the player, or a ball: the hand chooses bodies."); },
       take_up_hand, at("play/followed"), has_chosen},
      {"why", "Ask why",
       [](const Ui&) {
         return std::string(
             "\"Last stop\" goes back to the frame in which the player was stopped, and Why says what did "
             "it. Then click a sentence below: the play view draws that stage of the step.");
       },
       show_why, last_stop_or_tab, has_asked_why},
      {"back", "Go back in time",
       [](const Ui& ui) {
         return "Every frame is still there. " + keys_of("timeline/back"_command, ui) +
                ", or this button, goes back to the one before; the timeline above goes to any.";
       },
       show_nothing, at("transport/back"), has_gone_back},
  };
}

}  // namespace

TourStart tour_start(const Session& session) {
  const Body* player = followed_body(session.state(), 0);
  return {session.state().frame, session.state().frame, session.revision(), session.choices().overlays,
          player != nullptr ? player->box.x : 0};
}

std::span<const TourStep> tour_steps() {
  static const std::vector<TourStep> kSteps = all_steps();
  return kSteps;
}

}  // namespace talus
