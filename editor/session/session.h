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
#include "level/hard_case.h"
#include "level/lint.h"
#include "overlay/overlay_id.h"
#include "sim/solver.h"

namespace talus {

inline constexpr double kStepsPerSecond = 60;  // at speed 1; TIC-80's rate

// What the user has chosen; changed by the actions of the same names.
struct Choices {
  MapTool map_tool = MapTool::stamp;
  SpriteTool sprite_tool = SpriteTool::pencil;
  SpriteArea area;          // shown in the canvas and the flags panel
  Stamp stamp;              // painted on the map
  int color = 12;           // left button, 0..15
  int secondary_color = 0;  // right button, 0..15
  int body = 0;             // id of the chosen body; 0: none
  OverlaySet overlays;      // shown in the play view
  std::optional<int> flag_overlay;
  bool grid = true;
  bool screen_borders = true;
};

inline constexpr double kMinSpeed = 1.0 / 8;
inline constexpr double kMaxSpeed = 8;

struct Playback {
  bool running = false;
  double speed = 1;  // kMinSpeed to kMaxSpeed
  Input input;       // held until changed
};

inline constexpr const char* kUnnamed = "untitled";

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
  // path: the file that the level was read from, in the format of its extension; empty: none. name: for
  // titles, while there is no file.
  explicit Session(Level level = Level(), std::string path = {}, std::string name = kUnnamed);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Carries actions out, in order. An edit is fitted to the level as it is by then (see rebase_edit). What
  // the simulation sees of an edit is in the next step: bodies go on from where they are, except that at
  // frame 0 they start anew from the edited level.
  void apply(const Action& action);
  void apply(const Actions& actions);
  // Lets `seconds` (>= 0) of real time pass: makes the steps that are due, at most kMaxCatchUpSteps; after a
  // longer pause the rest is dropped.
  void advance(double seconds);
  static constexpr int kMaxCatchUpSteps = 64;

  const Level& level() const;
  std::uint64_t revision() const;  // grows with every change of the level, undo and opening included
  const UndoStack& history() const;
  const std::string& path() const;                   // empty when it has none
  std::string file_name() const;                     // for titles: "demo.talus.json"
  bool modified() const;                             // differs from the file
  const std::vector<Problem>& problems() const;      // lint of the level as it is
  const std::optional<HardCase>& hard_case() const;  // that the opened level is, whose input is played too

  const Scene& scene() const;        // of the level as it is
  const State& state() const;        // after the last finished step
  const StepRecord& record() const;  // of the last finished step; empty at frame 0
  const Playback& playback() const;
  const Choices& choices() const;

  const std::optional<Message>& message() const;    // stays until dismissed or replaced
  const std::optional<Question>& question() const;  // waits for AnswerQuestion
  bool wants_save_as() const;                       // waits for SaveFileAs or CancelSaveAs
  bool wants_quit() const;                          // the program should end

  // A number for a stroke that begins now, unlike that of any edit before. Ask once when a drag begins, and
  // give the same number to each of its edits.
  int next_stroke() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talus
