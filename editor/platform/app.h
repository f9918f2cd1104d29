// App: the editor. Owns the window, the session and the workspace, and runs them frame by frame.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "demo_hand.h"
#include "event_queue.h"
#include "file_browser.h"
#include "game_start.h"
#include "gamepads.h"
#include "gl_window.h"
#include "map_texture_cache.h"
#include "open_copies.h"
#include "panels/canvas/play_keys.h"
#include "panels/commands/keys.h"
#include "panels/window/workspace.h"
#include "picture_texture_cache.h"
#include "recent_pictures.h"
#include "session/session.h"
#include "settings.h"
#include "sheet_textures.h"
#include "small_picture_textures.h"
#include "user_folder.h"
#include "work_guard.h"

namespace talus {

struct AppOptions {
  std::string file;                    // file to open; empty: as the settings say
  int width = 0, height = 0;           // px, of the window; 0: as in the settings
  bool offscreen = false;              // without a display
  bool remember = true;                // reads and writes settings, and saves automatically
  std::function<double()> clock = {};  // s, never running backwards; empty: the machine's clock
  // Lets that many seconds of the clock pass, or less if an event comes; empty: waits.
  std::function<void(double seconds)> pause = {};
  Patience patience{std::chrono::milliseconds(2000), std::chrono::milliseconds(100)};
  std::vector<std::string> others = {};  // maps that are listed with `file`
  // A level of a file opens paused at its first screen, and not as the preferences say at what matters of it:
  // for tests that measure on the map.
  bool paused_at_first_screen = false;
};

class App {
 public:
  static tl::expected<std::unique_ptr<App>, std::string> start(AppOptions options);
  ~App();  // saves the settings

  void run();  // until the user quits
  // Waits for the next thing to do, and does it. If there is nothing to do, no frame is drawn.
  void turn();
  // One frame: handles the waiting events, lets time pass, and draws the window.
  void frame();
  // Draws the last frame once more, into a PNG.
  tl::expected<void, std::string> screenshot(const std::string& path) const;

  Session& session() { return *session_; }
  Ui& ui() { return ui_; }
  bool has_waiting_events() const { return !events_.empty(); }
  int drawn_frames() const { return drawn_frames_; }

 private:
  explicit App(AppOptions options) : options_(std::move(options)) {}
  std::string open_window(Settings& settings);  // returns the error, or an empty text
  void take_settings(const Settings& settings);
  Settings current_settings() const;
  std::string keep_settings_aside(const std::string& problem);
  std::string remember() const;  // returns what went wrong, or an empty text
  void remember_changes();
  void open_first_level();
  void play_opened_level();

  void hold_keys_while_dialogs_change();
  void hold_keys_until_field_focused();
  void handle_events();
  bool close_window(Actions& actions);
  bool keys_navigate_controls() const;
  bool capture_key(KeyChord chord, bool repeated);
  void open_wanted_program();
  void handle_key(const SDL_KeyboardEvent& key, Actions& actions);
  bool keys_are_taken(KeyChord chord) const;
  bool steer(KeyChord chord, Actions& actions);
  // Shows the demo level from its start again when all is at rest, until somebody touches something.
  void play_demo();
  void leave_demo();
  void handle_gamepad(const SDL_Event& event, Actions& actions);
  // What is held for the players, on the keyboard and on gamepads.
  action::HoldKeys held() const;
  void release(const SDL_Event& event, Actions& actions);
  void draw(Actions& actions);
  void draw_file_dialog(Actions& actions);
  void note_dialog_result();
  // Lets the session carry them out. A tool that they choose is taken up.
  void apply(const Actions& actions);
  void note_changes();
  void note_recent_file();
  void note_recent_picture();
  void dismiss_old_note();
  bool keeps_note() const;
  bool follow_work();                                // returns true if there is something new to show
  bool wait();                                       // returns whether a frame is due
  void pause(double seconds, bool for_event) const;  // for_event: ends when an event comes

  AppOptions options_;
  std::unique_ptr<GlWindow> window_;
  std::unique_ptr<SheetTextures> textures_;
  std::unique_ptr<MapTextureCache> map_textures_;
  std::unique_ptr<PictureTextureCache> picture_textures_;
  std::unique_ptr<SmallPictureTextures> small_pictures_;
  std::unique_ptr<Session> session_;
  Workspace workspace_;
  FileBrowser browser_;
  std::optional<WorkGuard> guard_;  // nothing if `remember` is false
  OpenCopies copies_{state_folder() + "/copies"};
  RecentPictures recent_pictures_{state_folder() + "/level_pictures"};
  GameStart game_start_;
  EventQueue events_;
  HeldPlayKeys play_keys_;
  Gamepads gamepads_;
  Ui ui_;

  double last_time_ = 0;    // s, of the last frame
  double last_event_ = 0;   // s, of the last event by the user or from outside
  std::string noted_path_;  // path of the session at the last look
  int noted_saves_ = 0;     // how often it had been saved then
  std::uint64_t noted_revision_ = 0;
  bool waits_for_file_ = false;  // that the program was started with
  std::string title_;
  bool dialog_answered_ = false;
  std::optional<FileDialog> asked_dialog_;   // the dialog for a file that the user has opened
  std::vector<std::string> wanted_dialogs_;  // titles, at the last look
  std::string wanted_field_;                 // the field that should get the keys, at the last look
  int frames_to_hold_ = 0;                   // number of frames in which presses wait
  std::string note_;                         // the message whose time is measured
  double note_since_ = 0;                    // s
  bool note_waits_ = false;                  // the user was elsewhere: its time has not begun
  Preferences noted_preferences_;            // the preferences that were saved last
  std::string remember_problem_;             // the last problem that was shown
  bool remembers_settings_ = true;           // false: the file has settings that could not be read
  int drawn_frames_ = 0;
  std::optional<DemoHand> demo_hand_;  // while the demo level is open and nobody has touched it
};

// Runs the editor on these files, of which the first in the order of names is opened; none: as the
// settings say.
// Returns the exit status.
int run_editor(const std::vector<std::string>& files);

}  // namespace talus
