#include "tour_steps.h"

#include <cmath>

#include "panels/canvas/opening_area.h"
#include "panels/commands/commands.h"
#include "panels/panel_ids.h"

namespace talus {
namespace {

using S = const Session&;
using Start = const TourStart&;

constexpr double kFarEnough = 16;  // px that the player has run

void show_play_view(Ui& ui) {
  if (ui.view.canvas.mode != CanvasMode::play) ui.view.canvas.mode = CanvasMode::both;
  ui.view.canvas.follow_body = true;
}

// Where a click chooses a body, also after the step that paints.
void take_up_hand(Ui& ui) {
  show_play_view(ui);
  ui.view.canvas.paint_in_play = false;
}

void show_nothing(Ui&) {}

std::function<std::string_view(const Ui&)> at(std::string_view widget) {
  return [widget](const Ui&) { return widget; };
}

bool has_run(S session, const Ui&, Start start) {
  const Input& held = session.playback().input;
  return session.playback().running && (held.left || held.right) &&
         std::abs(tour_start(session).player_x - start.player_x) >= kFarEnough;
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

bool has_opened_stage(S, const Ui& ui, Start) { return ui.view.debugger.stage >= 0; }

bool has_gone_back(S session, const Ui&, Start start) { return session.state().frame < start.last_frame; }

// A stage of the step where the panel shows some, else its tab.
std::string_view stage_or_tab(const Ui& ui) {
  constexpr std::string_view kStage = "why/stage0";
  return ui.widgets.find(kStage) != nullptr ? kStage : "tabs/why";
}

std::string_view map_or_level(const Ui& ui) {
  constexpr std::string_view kMap = "map/canvas";
  return ui.widgets.find(kMap) != nullptr ? kMap : "play/canvas";
}

void show_why(Ui& ui) {
  ui.view.debugger.stage = -1;
  ui.ask(request::ShowTab(panel_id::kWhy));
}

// Of the commands of one kind, as "Left or Right".
std::string two_keys(CommandId first, CommandId second, const Ui& ui) {
  return keys_of(first, ui) + " or " + keys_of(second, ui);
}

std::vector<TourStep> all_steps() {
  return {
      {"run", "Run",
       [](const Ui& ui) {
         return "Hold " + two_keys("player/left"_command, "player/right"_command, ui) +
                ": the player runs. " + keys_of("player/jump"_command, ui) + " jumps.";
       },
       show_play_view, at("play/canvas"), has_run},
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
       show_nothing, map_or_level, has_edited},
      {"overlays", "See the physics",
       [](const Ui&) {
         return std::string(
             "The eye has overlays that answer a question together. Choose what the article draws.");
       },
       show_play_view, at("overlay/presets"), has_switched},
      {"choose", "Choose a body",
       [](const Ui&) { return std::string("Click the player, or a ball: the hand chooses bodies."); },
       take_up_hand, at("play/followed"), has_chosen},
      {"why", "Ask why",
       [](const Ui&) {
         return std::string(
             "Why tells each stage of the body's last step in a sentence. Click a stage: the play view draws "
             "it.");
       },
       show_why, stage_or_tab, has_opened_stage},
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
