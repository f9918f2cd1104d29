// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Draws what is on a map with SDL: pictures and plain forms. All places and lengths are px of the map.
#pragma once

#include <SDL.h>
#include <talus/level/placed_picture.h>

#include <map>
#include <memory>
#include <span>

namespace game {

// Multiplies the colours of a picture.
struct Shade {
  talus::Rgb tint = {255, 255, 255};
  double opacity = 1;  // 0..1
};

class Painter {
 public:
  explicit Painter(SDL_Renderer* renderer) : renderer_(renderer) {}

  struct Size {
    int width = 0, height = 0;  // pixels of the screen
  };
  Size size() const;

  // Shows the map from this corner on, so many pixels of the screen for each px: a whole number, from 1.
  void look_at(talus::Vec2 corner, int zoom);
  talus::Rect view() const;                                    // what is seen of the map
  talus::Vec2 on_map(double screen_x, double screen_y) const;  // what a pixel of the screen shows
  talus::Vec2 on_whole_pixels(talus::Vec2 place) const;        // which keep pixel art sharp

  void clear(talus::Rgb color);
  void draw(const talus::PlacedPicture& shown, talus::Vec2 shift, const Shade& shade);
  void polygon(std::span<const talus::Vec2> corners, talus::Rgb color);  // without dents
  void rectangle(const talus::Rect& box, talus::Rgb color);
  void line(talus::Vec2 from, talus::Vec2 to, double width, talus::Rgb color);
  // turn: radians, clockwise.
  void ellipse(talus::Vec2 middle, talus::Vec2 radii, double turn, talus::Rgb color);
  void disc(talus::Vec2 middle, double radius, talus::Rgb color) {
    ellipse(middle, {radius, radius}, 0, color);
  }

 private:
  struct Texture {
    std::shared_ptr<const talus::SheetPicture> picture;  // so that no other gets its address
    std::unique_ptr<SDL_Texture, decltype(&SDL_DestroyTexture)> sdl{nullptr, SDL_DestroyTexture};
  };
  // Null: SDL cannot make it, which was said.
  SDL_Texture* texture_of(const std::shared_ptr<const talus::SheetPicture>& picture);
  SDL_FPoint on_screen(talus::Vec2 place) const;

  SDL_Renderer* renderer_;
  talus::Vec2 corner_;
  int zoom_ = 1;
  std::map<const talus::SheetPicture*, Texture> textures_;
};

}  // namespace game
