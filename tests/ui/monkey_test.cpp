// A monkey at the mouse and the keys: random events, after which all edits are undone. TALUS_MONKEY_EVENTS
// and TALUS_MONKEY_SEED choose how many and which.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>

#include <talus/formats/format.h>
#include "harness.h"
#include "panels/commands/commands.h"

namespace talus::monkey_test {

constexpr int kEvents = 1500;  // what a build with sanitizers makes in less than a minute
constexpr int kTold = 10000;   // a long run prints its progress after so many events

int number_from(const char* variable, int standard) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : standard;
}

class UiMonkey : public UiTest {
 protected:
  void make_files() {
    files_ = {save_test_level("level.talus.json"), save_test_level("other.tic"), path("broken.talus.json"),
              path("empty.talusrec"), path("missing.tic")};
    std::ofstream(files_[2]) << R"({"talus": 1, "map": {"width": 3)";
    std::ofstream(files_[3]) << "";
  }

  int any(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool chance(int percent) { return any(100) < percent; }

  // Mostly onto a widget, where something may happen.
  ImVec2 somewhere() {
    const auto& all = app().ui().widgets.all();
    if (all.empty() || chance(40)) return {static_cast<float>(any(1280)), static_cast<float>(any(720))};
    const Widget& widget = all[static_cast<std::size_t>(any(static_cast<int>(all.size())))];
    const auto between = [&](float a, float b) { return a + (b - a) * static_cast<float>(any(101)) / 100; };
    return {between(widget.min.x, widget.max.x), between(widget.min.y, widget.max.y)};
  }

  KeyChord any_chord() {
    constexpr int kOthers[] = {SDLK_ESCAPE, SDLK_RETURN, SDLK_BACKSPACE, kKeyTab, ' ', kKeyDelete};
    if (chance(25)) return {kOthers[any(std::size(kOthers))], chance(10), chance(20), chance(5)};
    const auto all = commands();
    const Command& command = all[static_cast<std::size_t>(any(static_cast<int>(all.size())))];
    return command.other_key && chance(50) ? command.other_key : command.key;
  }

  void do_something() {
    const int what = any(100);
    if (what < 30) return move(somewhere());
    if (what < 45) return click(somewhere(), any(4) == 0 ? kRight : kLeft);
    if (what < 58) return toggle_button();
    if (what < 64) return wheel(any(7) - 3);
    if (what < 85) {
      if (const KeyChord chord = any_chord()) key(chord);
      return;
    }
    if (what < 98) return type(std::string(1, static_cast<char>(' ' + any(95))));
    if (what < 99) drop(files_[static_cast<std::size_t>(any(static_cast<int>(files_.size())))]);
  }

  void toggle_button() {
    if (down_ != 0) {
      release(down_);
      down_ = 0;
    } else {
      down_ = any(6) == 0 ? kMiddle : any(3) == 0 ? kRight : kLeft;
      press(down_);
    }
  }

  bool shows_files() {
    const std::vector<std::string> dialogs = app().ui().wanted_dialogs(session());
    return std::find(dialogs.begin(), dialogs.end(), "Files") != dialogs.end();
  }

  // Lets the monkey write into the test's folder only, and start no other program.
  void keep_in_the_cage() {
    View& view = app().ui().view;
    view.preferences.programs = {};
    if (session().wants_save_as()) session().apply(action::CancelSaveAs{});
    for (int i = 0; i < 5 && shows_files(); ++i) key(kKeyEscape);
    if (view.canvas.level_number == level_number_) return;
    level_number_ = view.canvas.level_number;
    first_ = level();
    EXPECT_TRUE(session().history().edits().empty());
  }

  std::mt19937_64 random_{static_cast<std::uint64_t>(number_from("TALUS_MONKEY_SEED", 1))};
  std::vector<std::string> files_;
  int down_ = 0;  // the held button; 0: none
  int level_number_ = -1;
  Level first_;  // as it was when it was opened last
};

TEST_F(UiMonkey, BreaksNothingAndEverythingIsUndone) {
  make_files();
  start(files_[0]);
  keep_in_the_cage();
  const int events = number_from("TALUS_MONKEY_EVENTS", kEvents);
  for (int i = 0; i < events; ++i) {
    SCOPED_TRACE("event " + std::to_string(i));
    do_something();
    keep_in_the_cage();
    if (HasFailure()) return;
    if ((i + 1) % kTold == 0) std::cout << i + 1 << " events" << std::endl;
  }
  if (down_ != 0) release(down_);
  session().apply({action::AnswerQuestion{}, action::CancelRerun{}, action::Pause{}});
  while (session().history().can_undo()) session().apply(action::Undo{});
  EXPECT_TRUE(level() == first_);
}

}  // namespace talus::monkey_test
