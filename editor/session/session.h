// Session: one open level with its history, its running simulation and what the user has chosen. The only way
// to change it is apply(); panels see it const.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "actions.h"
#include "edit/undo_stack.h"
#include "formats/format.h"
#include "level/lint.h"
#include "overlay/overlay_id.h"
#include "sim/solver.h"

namespace talus {

inline constexpr double kStepsPerSecond = 60;  // at speed 1; TIC-80's rate

// What the user has chosen; changed by the actions of the same names.
struct Choices {
  MapTool map_tool = MapTool::stamp;
  SpriteTool sprite_tool = SpriteTool::pencil;
  SpriteArea area;            // shown in the canvas and the flags panel
  Stamp stamp;                // painted on the map
  int color = 12;             // left button, 0..15
  int secondary_color = 0;    // right button, 0..15
  int body = 0;               // id of the chosen body; 0: none
  OverlaySet overlays;        // shown in the play view
  std::optional<int> flag_overlay;
  bool grid = true;
  bool screen_borders = true;
};

struct Playback {
  bool running = false;
  double speed = 1;  // 1/8 to 8
  Input input;       // held until changed
};

struct Message {
  std::string text;
  bool is_error = false;
};

// Something that would lose unsaved changes waits for an answer.
struct Question {
  std::string text;  // "Save the changes to demo.talus.json?"
};

class Session {
 public:
  explicit Session(Level level = {}, std::string path = {});  // path: empty for a level without a file
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void apply(const Action& action);
  void apply(const Actions& actions);
  // Lets `seconds` of real time pass: makes the steps that are due, at most kMaxCatchUpSteps.
  void advance(double seconds);
  static constexpr int kMaxCatchUpSteps = 64;

  const Level& level() const;
  std::uint64_t revision() const;  // grows with every change of the level, undo and opening included
  const UndoStack& history() const;
  const std::string& path() const;  // empty when it has none
  std::string file_name() const;    // for titles: "demo.talus.json", or "untitled"
  bool modified() const;            // differs from the file
  const std::vector<Problem>& problems() const;  // lint of the level as it is

  const Scene& scene() const;        // of the level as it is
  const State& state() const;        // after the last finished step
  const StepRecord& record() const;  // of the last finished step; empty at frame 0
  const Playback& playback() const;
  const Choices& choices() const;

  const std::optional<Message>& message() const;    // stays until dismissed or replaced
  const std::optional<Question>& question() const;  // waits for AnswerQuestion
  bool wants_save_as() const;                       // waits for SaveFileAs or CancelSaveAs
  bool wants_quit() const;                          // the program should end

  // A number for the next stroke of edits, unlike any before.
  int next_stroke() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talus
