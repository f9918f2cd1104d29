// UiTest runs the real editor without a display, sends it SDL events like a user's hand, and finds its
// widgets by name. A failed test leaves a picture of the window in the build directory's ui-failures/.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "panels/commands/keys.h"
#include "platform/app.h"
#include "unit/folder_test.h"

namespace talus {

class UiTest : public ::testing::Test {
 protected:
  static constexpr int kLeft = SDL_BUTTON_LEFT, kRight = SDL_BUTTON_RIGHT, kMiddle = SDL_BUTTON_MIDDLE;

  void TearDown() override;

  // Starts the editor on a file, after ending the running one.
  void start(const std::string& file, int width = 1280, int height = 720);
  // Starts the editor on test_level().
  void start() { start(save_test_level("level.talus.json")); }
  // The same with tile 1 as the stamp and the keys on the map.
  void start_on_the_map() {
    start();
    click(on_sheet(1));
    key(kKeyF3);
  }
  void stop() { app_.reset(); }
  // From the next start on, levels open as they do for a user: at what matters of them, playing, and
  // followed. Else they open paused at their first screen.
  void open_as_users_do() { opens_paused_ = false; }
  // The same for the first layout. Else the first start shows the map above the play view, between wide
  // columns.
  void begin_with_the_first_layout() { shows_both_ = false; }
  // Lets that time pass, in which the window draws a frame only if there is a reason.
  void turn_for(double seconds);

  // 30x17 cells with a floor in row 16. Tiles: 1 solid, 2 ball, 3 and 4 up-slope, 5 and 6 down-slope. A ball
  // lies in cell (5,10). The solver is the article's.
  static Level test_level();
  std::string save_test_level(const std::string& name);
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string bytes_of(const std::string& file);

  App& app() { return *app_; }
  Session& session() { return app_->session(); }
  const Level& level() { return session().level(); }
  TileNumber tile_at(Cell cell) { return level().map.tile_at(cell); }
  const Body& ball() { return session().state().bodies.at(0); }

  // Lets `count` frames of 1/60 s pass, and more while events wait.
  void frames(int count = 1);
  // Lets frames pass until threads have done what `is_so` asks for. Returns false if they hang.
  bool frames_until(const std::function<bool()>& is_so);

  const Widget* find(std::string_view name) { return app_->ui().widgets.find(name); }
  ImVec2 centre(std::string_view name);  // fails the test if there is no such widget
  // Converts a place on the "map" or "play" canvas from level px to window px.
  ImVec2 on_canvas(const std::string& canvas, Vec2 level);
  ImVec2 on_map(Cell cell) { return on_canvas("map", level().map.box_of(cell).center()); }
  ImVec2 on_pixels(int x, int y);  // on the pixel canvas
  ImVec2 on_sheet(int tile);       // which is brought into sight

  void move(ImVec2 to);
  void press(int button = kLeft);
  void release(int button = kLeft);
  void click(ImVec2 at, int button = kLeft);
  void click(std::string_view name, int button = kLeft) { click(centre(name), button); }
  void drag(ImVec2 from, ImVec2 to, int button = kLeft);
  void wheel(int clicks);
  void key(KeyChord chord);
  void key(int key_code) { key(KeyChord{key_code}); }
  void hold(int key_code);  // until let_go()
  void let_go(int key_code);
  // Holds these of Ctrl, Shift and Alt from now on; an empty chord releases all.
  void hold_modifiers(KeyChord chord = {});
  void type(const std::string& text);
  // Events that a fast hand makes before a slow frame: pushed without any frame in between.
  void push_typing(const std::string& text);  // each letter's press, text and release
  void push_stroke(KeyChord chord);           // press and release
  void push_click(ImVec2 at, int button = kLeft);
  // Presses the button at the first place, moves over the others, and releases it at the last.
  void push_drag(const std::vector<ImVec2>& places, int button = kLeft);
  void drop(const std::string& file);
  void drop_all(const std::vector<std::string>& files);  // in one gesture

 private:
  void show_both(int width);  // px, of the window
  ImVec2 place_on_sheet(int tile);
  void push(SDL_Event event);
  void push_key(SDL_Keysym sym, bool down);
  void push_motion(ImVec2 to);
  void push_button(int button, bool down);
  void push_text(char c);

  const std::filesystem::path folder_ = new_folder("talus-ui-");  // for the files of the test
  const EnvironmentVariable config_folder_{"TALUS_CONFIG_DIR", path("config")};
  const EnvironmentVariable state_folder_{"TALUS_STATE_DIR", path("state")};
  double clock_ = 100;    // s
  double turns_end_ = 0;  // s
  bool opens_paused_ = true;
  bool shows_both_ = true;  // the map and the play view, at the first start of a test
  ImVec2 mouse_{0, 0};
  std::unique_ptr<App> app_;
};

}  // namespace talus
