// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// A game that plays a level made with Talus in a window, to the same doubles as the editor. It is yours to
// change.
//   game [FILE [STEPS [KEYS [PICTURE]]]]
// FILE: a level or a TIC-80 cart; by default level.talus.json beside this file. With STEPS there is no
// window: see headless.h.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "controls.h"
#include "headless.h"
#include "play.h"

namespace {

constexpr int kWidth = 960, kHeight = 544;  // of the window at first
constexpr int kMaxSteps = 4;                // at once; after a longer pause the rest is dropped
constexpr const char* kTitle = "arrows: run, jump     mouse: drag     R: start again     Esc: end";

// Plays until the window is closed. Whether all went well.
bool run(SDL_Renderer* renderer, const std::string& file) {
  auto play = game::load(file);
  game::Painter painter(renderer);
  game::Controls controls;
  const double ticks_of_step = static_cast<double>(SDL_GetPerformanceFrequency()) / game::kStepsPerSecond;
  double due = 0;  // steps
  Uint64 before = SDL_GetPerformanceCounter();
  while (play) {
    play->draw(painter);
    SDL_RenderPresent(renderer);
    SDL_Delay(1);  // for screens that are not waited for
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
      controls.handle(event);
      const bool is_key = event.type == SDL_KEYDOWN && event.key.repeat == 0;
      if (event.type == SDL_QUIT || (is_key && event.key.keysym.sym == SDLK_ESCAPE)) return true;
      if (is_key && event.key.keysym.sym == SDLK_r) play = game::load(file);  // as the file is now
      if (!play) return false;
    }
    const Uint64 now = SDL_GetPerformanceCounter();
    due = std::min(due + static_cast<double>(now - before) / ticks_of_step, 1.0 * kMaxSteps);
    before = now;
    for (; due >= 1; --due) play->step(controls.held(painter));
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : LEVEL_FILE;
  if (argc > 2)
    return game::replay(file, std::atoi(argv[2]), argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "") ? 0 : 1;

  SDL_SetMainReady();
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_GAMECONTROLLER) == 0)
    window = SDL_CreateWindow(kTitle, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, kWidth, kHeight,
                              SDL_WINDOW_RESIZABLE);
  if (window != nullptr) renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
  if (renderer == nullptr) std::cerr << "there is no window: " << SDL_GetError() << '\n';
  const bool is_good = renderer != nullptr && run(renderer, file);
  SDL_DestroyRenderer(renderer);
  SDL_DestroyWindow(window);
  SDL_Quit();
  return is_good ? 0 : 1;
}
