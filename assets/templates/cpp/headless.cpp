// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "headless.h"

#include <iostream>
#include <memory>

#include "play.h"

namespace game {
namespace {

// What the player holds in a step, from 0.
talus::Input keys_at(const std::string& keys, int step) {
  constexpr std::size_t kStepsOfKey = 10;
  const auto at = static_cast<std::size_t>(step) / kStepsOfKey;
  const char key = at < keys.size() ? keys[at] : '.';
  talus::Input input;
  input.left = key == 'l' || key == 'L';
  input.right = key == 'r' || key == 'R';
  input.jump = key == 'j' || key == 'L' || key == 'R';
  return input;
}

bool save_picture(Play& play, const std::string& file) {
  constexpr int kWidth = 960, kHeight = 544;  // a screen of TIC-80, of 240x136 px, with 4 pixels for each px
  const std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)> surface(
      SDL_CreateRGBSurfaceWithFormat(0, kWidth, kHeight, 32, SDL_PIXELFORMAT_RGB888), SDL_FreeSurface);
  const std::unique_ptr<SDL_Renderer, decltype(&SDL_DestroyRenderer)> renderer(
      SDL_CreateSoftwareRenderer(surface.get()), SDL_DestroyRenderer);
  Painter painter(renderer.get());
  play.draw(painter);
  SDL_RenderPresent(renderer.get());
  if (SDL_SaveBMP(surface.get(), file.c_str()) == 0) return true;
  std::cerr << file << ": error: " << SDL_GetError() << '\n';
  return false;
}

}  // namespace

bool replay(const std::string& file, int steps, const std::string& keys, const std::string& picture) {
  const auto play = load(file);
  if (!play) return false;
  for (int step = 0; step < steps; ++step) play->step(keys_at(keys, step));
  std::cout << std::hex << talus::state_hash(play->state()) << '\n';
  return picture.empty() || save_picture(*play, picture);
}

}  // namespace game
