// The hand and the eyes of the tests.
#include "harness.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <utility>

#include <talus/formats/format.h>
#include "paths.h"
#include "platform/sdl_keys.h"
#include "unit/waiting.h"

namespace talus {

namespace fs = std::filesystem;

void UiTest::TearDown() {
  if (HasFailure() && app_) {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    const fs::path picture = fs::path(build_path("ui-failures")) / (std::string(info->name()) + ".png");
    fs::create_directories(picture.parent_path());
    const auto taken = app_->screenshot(picture.string());
    std::cout << (taken ? "See " + picture.string() : "No picture: " + taken.error()) << '\n';
  }
  stop();
  remove_folder(folder_);
}

void UiTest::start(const std::string& file, int width, int height) {
  stop();
  AppOptions options;
  options.file = file;
  options.width = width;
  options.height = height;
  options.offscreen = true;
  options.clock = [this] { return clock_; };
  options.pause = [this](double seconds) { clock_ += std::min(seconds, turns_end_ - clock_); };
  options.patience = Patience();
  options.paused_at_first_screen = opens_paused_;
  auto app = App::start(std::move(options));
  ASSERT_TRUE(app) << app.error();
  app_ = std::move(*app);
  if (std::exchange(shows_both_, false)) show_both(width);
  app_->session().finish_reading();  // waits for a large file
  frames(3);
}

void UiTest::show_both(int width) {
  View& view = app_->ui().view;
  view.canvas.mode = CanvasMode::both;
  view.window.layout.left = std::max(0.215, 276.0 / width);
  view.window.layout.right = 0.305;
}

void UiTest::turn_for(double seconds) {
  turns_end_ = clock_ + seconds;
  while (clock_ < turns_end_) app_->turn();
}

Level UiTest::test_level() {
  Level level;
  level.tuning.solver = SolverKind::article;
  level.map = TileMap(30, 17);
  for (int x = 0; x < 30; ++x) level.map.set({x, 16}, 1);
  level.map.set({5, 10}, 2);
  Sheet& tiles = level.sheet(SheetId::tiles);
  tiles.flags[1] = 1;
  tiles.flags[2] = 2;
  tiles.flags[3] = 4;
  tiles.flags[5] = 8;
  tiles.images[1].fill(13);
  for (int y = 1; y < 7; ++y)
    for (int x = 1; x < 7; ++x) tiles.images[2][static_cast<std::size_t>(y * 8 + x)] = 3;
  for (int tile = 3; tile <= 6; ++tile) tiles.images[static_cast<std::size_t>(tile)].fill(14);
  return level;
}

std::string UiTest::save_test_level(const std::string& name) {
  const std::string file = path(name);
  const auto saved = save_level(test_level(), *format_for_file(file), file);
  EXPECT_TRUE(saved);
  return file;
}

std::string UiTest::bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

void UiTest::frames(int count) {
  for (int i = 0; i < count || app_->has_waiting_events(); ++i) {
    clock_ += 1.0 / 60;
    app_->frame();
  }
}

bool UiTest::frames_until(const std::function<bool()>& is_so) {
  return comes_true([&] {
    if (is_so()) return true;
    frames(1);
    return is_so();
  });
}

ImVec2 UiTest::centre(std::string_view name) {
  const bool is_overlay = name.starts_with("overlay/");
  if (find(name) == nullptr && !is_overlay &&
      find("canvas/more") != nullptr) {  // it may have no room in the toolbar
    click(find("canvas/more")->centre());
    frames(2);
  }
  if (find(name) == nullptr && is_overlay) {  // it is in the list of its group
    const Overlay* overlay = find_overlay(name.substr(name.find('/') + 1));
    if (overlay != nullptr) {
      const auto group = static_cast<std::size_t>(overlay->group);
      click("overlay/group_" + std::string(kOverlayGroups[group].key));
      frames(2);
    }
  }
  const Widget* widget = find(name);
  EXPECT_NE(widget, nullptr) << "no widget " << name;
  return widget ? widget->centre() : ImVec2(0, 0);
}

ImVec2 UiTest::on_canvas(const std::string& canvas, Vec2 at) {
  const ImVec2 from = centre(canvas + "/canvas"), to{from.x + 32, from.y};
  move(from);
  const auto first = app_->ui().view.canvas.hover.pixel;
  move(to);
  const auto second = app_->ui().view.canvas.hover.pixel;
  if (!first || !second) {
    ADD_FAILURE() << "the mouse is not over " << canvas;
    return {0, 0};
  }
  const double zoom = 32 / (second->x - first->x);
  return {static_cast<float>(from.x + (at.x - first->x) * zoom),
          static_cast<float>(from.y + (at.y - first->y) * zoom)};
}

ImVec2 UiTest::on_pixels(int x, int y) {
  const Widget* canvas = find("pixels/canvas");
  const SpriteArea& area = session().choices().area;
  if (!canvas) return {0, 0};
  return {canvas->min.x + (canvas->max.x - canvas->min.x) * (static_cast<float>(x) + 0.5f) /
                              static_cast<float>(area.width()),
          canvas->min.y + (canvas->max.y - canvas->min.y) * (static_cast<float>(y) + 0.5f) /
                              static_cast<float>(area.height())};
}

// Moves the sheet with the middle button if the tile is not in sight.
ImVec2 UiTest::on_sheet(int tile) {
  const Widget* canvas = find("sheet/canvas");
  if (!canvas) return {0, 0};
  const ImVec2 from = canvas->min, to = canvas->max;
  // More than a hand trembles.
  const auto missing = [](float at, float least, float most) {
    return at < least ? at - least - 16 : at > most ? at - most + 16 : 0;
  };
  ImVec2 at = place_on_sheet(tile);
  for (int drags = 0; drags < 100; ++drags, at = place_on_sheet(tile)) {
    const ImVec2 by{missing(at.x, from.x + 8, to.x - 8), missing(at.y, from.y + 8, to.y - 8)};
    if (by.x == 0 && by.y == 0) break;
    const ImVec2 grip{by.x > 0 ? to.x - 4 : from.x + 4, by.y > 0 ? to.y - 4 : from.y + 4};
    const ImVec2 end{std::clamp(grip.x - by.x, from.x + 2, to.x - 2),
                     std::clamp(grip.y - by.y, from.y + 2, to.y - 2)};
    drag(grip, end, kMiddle);
  }
  return at;
}

ImVec2 UiTest::place_on_sheet(int tile) {
  const Widget* sheet = find("sheet/tiles") ? find("sheet/tiles") : find("sheet/sprites");
  if (!sheet) return {0, 0};
  const SheetLayout layout = level().sheet(session().choices().area.sheet).layout();
  const float cell = (sheet->max.x - sheet->min.x) / static_cast<float>(layout.columns);
  const Cell place = layout.place_of(tile);
  return {sheet->min.x + cell * (static_cast<float>(place.x) + 0.5f),
          sheet->min.y + cell * (static_cast<float>(place.y) + 0.5f)};
}

void UiTest::push(SDL_Event event) { ASSERT_EQ(SDL_PushEvent(&event), 1) << SDL_GetError(); }

void UiTest::push_motion(ImVec2 to) {
  mouse_ = {std::floor(to.x), std::floor(to.y)};
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<int>(mouse_.x);
  event.motion.y = static_cast<int>(mouse_.y);
  push(event);
}

void UiTest::push_button(int button, bool down) {
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = static_cast<Uint8>(button);
  event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.button.clicks = 1;
  event.button.x = static_cast<int>(mouse_.x);
  event.button.y = static_cast<int>(mouse_.y);
  push(event);
}

void UiTest::push_text(char c) {
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  event.text.text[0] = c;
  push(event);
}

void UiTest::push_typing(const std::string& text) {
  for (char c : text) {
    const SDL_Keysym sym = keysym_of({c});
    push_key(sym, true);
    push_text(c);
    push_key(sym, false);
  }
}

void UiTest::push_stroke(KeyChord chord) {
  push_key(keysym_of(chord), true);
  push_key(keysym_of(chord), false);
}

void UiTest::push_click(ImVec2 at, int button) {
  push_motion(at);
  push_button(button, true);
  push_button(button, false);
}

void UiTest::push_drag(const std::vector<ImVec2>& places, int button) {
  push_motion(places.front());
  push_button(button, true);
  for (std::size_t i = 1; i < places.size(); ++i) push_motion(places[i]);
  push_button(button, false);
}

void UiTest::move(ImVec2 to) {
  push_motion(to);
  frames();
}

void UiTest::press(int button) {
  push_button(button, true);
  frames();
}

void UiTest::release(int button) {
  push_button(button, false);
  frames();
}

void UiTest::click(ImVec2 at, int button) {
  move(at);
  press(button);
  release(button);
  frames();
}

void UiTest::drag(ImVec2 from, ImVec2 to, int button) {
  move(from);
  press(button);
  for (int i = 1; i <= 4; ++i)
    move({from.x + (to.x - from.x) * static_cast<float>(i) / 4,
          from.y + (to.y - from.y) * static_cast<float>(i) / 4});
  release(button);
  frames();
}

void UiTest::wheel(int clicks) {
  SDL_Event event{};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.y = clicks > 0 ? 1 : -1;
#if SDL_VERSION_ATLEAST(2, 0, 18)
  event.wheel.preciseY = static_cast<float>(event.wheel.y);
#endif
  for (int i = 0; i < std::abs(clicks); ++i) push(event);
  frames();
}

void UiTest::push_key(SDL_Keysym sym, bool down) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.key.keysym = sym;
  push(event);
}

void UiTest::key(KeyChord chord) {
  SDL_Keysym sym = keysym_of(chord);
  push_key(sym, true);
  frames();
  sym.mod = KMOD_NONE;
  push_key(sym, false);
  frames();
}

void UiTest::hold(int key_code) {
  push_key(keysym_of({key_code}), true);
  frames();
}

void UiTest::let_go(int key_code) {
  push_key(keysym_of({key_code}), false);
  frames();
}

void UiTest::hold_modifiers(KeyChord chord) {
  SDL_Keysym sym = keysym_of(chord);
  sym.sym = SDLK_LSHIFT;
  sym.scancode = SDL_SCANCODE_LSHIFT;
  push_key(sym, chord.ctrl || chord.shift || chord.alt);
  frames();
}

void UiTest::type(const std::string& text) {
  for (char c : text) push_text(c);
  frames(2);
}

void UiTest::drop(const std::string& file) { drop_all({file}); }

void UiTest::drop_all(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    SDL_Event event{};
    event.type = SDL_DROPFILE;
    event.drop.file = SDL_strdup(file.c_str());
    push(event);
  }
  frames(2);
}

}  // namespace talus
