// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "painter.h"

#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

namespace game {

using talus::Vec2;

void Painter::look_at(Vec2 corner, int zoom) {
  zoom_ = zoom;
  corner_ = {std::floor(corner.x * zoom) / zoom, std::floor(corner.y * zoom) / zoom};
}

Painter::Size Painter::size() const {
  Size size;
  SDL_GetRendererOutputSize(renderer_, &size.width, &size.height);
  return size;
}

talus::Rect Painter::view() const {
  const auto [width, height] = size();
  return {corner_.x, corner_.y, 1.0 * width / zoom_, 1.0 * height / zoom_};
}

Vec2 Painter::on_map(double screen_x, double screen_y) const {
  return {corner_.x + screen_x / zoom_, corner_.y + screen_y / zoom_};
}

Vec2 Painter::on_whole_pixels(Vec2 place) const {
  return {std::floor(place.x * zoom_ + 0.5) / zoom_, std::floor(place.y * zoom_ + 0.5) / zoom_};
}

SDL_FPoint Painter::on_screen(Vec2 place) const {
  return {static_cast<float>((place.x - corner_.x) * zoom_),
          static_cast<float>((place.y - corner_.y) * zoom_)};
}

void Painter::clear(talus::Rgb color) {
  SDL_SetRenderDrawColor(renderer_, color.r, color.g, color.b, 255);
  SDL_RenderClear(renderer_);
}

SDL_Texture* Painter::texture_of(const std::shared_ptr<const talus::SheetPicture>& picture) {
  const auto [at, is_new] = textures_.try_emplace(picture.get(), Texture{picture});
  auto& texture = at->second.sdl;
  if (!is_new) return texture.get();
  const int width = picture->width, height = picture->height;
  texture.reset(
      SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC, width, height));
  if (!texture || SDL_UpdateTexture(texture.get(), nullptr, picture->rgba.data(), 4 * width) != 0)
    std::cerr << "a picture of " << width << 'x' << height << " px is not drawn: " << SDL_GetError() << '\n';
  SDL_SetTextureBlendMode(texture.get(), SDL_BLENDMODE_BLEND);
  return texture.get();
}

// SDL turns a rectangle around its middle, after it has changed top and bottom. So each place of a picture is
// made.
void Painter::draw(const talus::PlacedPicture& shown, Vec2 shift, const Shade& shade) {
  const talus::PicturePart& part = shown.part;
  SDL_Texture* texture = texture_of(part.picture);
  SDL_SetTextureColorMod(texture, shade.tint.r, shade.tint.g, shade.tint.b);
  SDL_SetTextureAlphaMod(texture, static_cast<Uint8>(std::lround(255 * shade.opacity)));
  const SDL_Rect from{part.x, part.y, part.width, part.height};
  const Vec2 right = shown.right, down = shown.down;
  const auto width = static_cast<float>(std::hypot(right.x, right.y) * zoom_);
  const auto height = static_cast<float>(std::hypot(down.x, down.y) * zoom_);
  const SDL_FPoint middle = on_screen(shown.corner + (right + down) * 0.5 + shift);
  const SDL_FRect to{middle.x - width / 2, middle.y - height / 2, width, height};
  const double degrees = std::atan2(right.y, right.x) * 180 / std::numbers::pi;
  const bool is_mirrored = right.x * down.y < right.y * down.x;
  SDL_RenderCopyExF(renderer_, texture, &from, &to, degrees, nullptr,
                    is_mirrored ? SDL_FLIP_VERTICAL : SDL_FLIP_NONE);
}

void Painter::polygon(std::span<const Vec2> corners, talus::Rgb color) {
  std::vector<SDL_Vertex> points;
  std::vector<int> triangles;
  for (const Vec2 corner : corners) {
    const int last = static_cast<int>(points.size());
    if (last >= 2) triangles.insert(triangles.end(), {0, last - 1, last});
    points.push_back({on_screen(corner), {color.r, color.g, color.b, 255}, {}});
  }
  SDL_RenderGeometry(renderer_, nullptr, points.data(), static_cast<int>(points.size()), triangles.data(),
                     static_cast<int>(triangles.size()));
}

void Painter::rectangle(const talus::Rect& box, talus::Rgb color) {
  const Vec2 corners[] = {
      {box.x, box.y}, {box.right(), box.y}, {box.right(), box.bottom()}, {box.x, box.bottom()}};
  polygon(corners, color);
}

void Painter::line(Vec2 from, Vec2 to, double width, talus::Rgb color) {
  const Vec2 way = to - from;
  const double length = std::hypot(way.x, way.y);
  if (length == 0) return;
  const Vec2 beside = Vec2{-way.y, way.x} * (width / 2 / length);
  const Vec2 corners[] = {from + beside, to + beside, to - beside, from - beside};
  polygon(corners, color);
}

void Painter::ellipse(Vec2 middle, Vec2 radii, double turn, talus::Rgb color) {
  constexpr int kCorners = 64;
  const double cosine = std::cos(turn), sine = std::sin(turn);
  std::vector<Vec2> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    const double x = radii.x * std::cos(angle), y = radii.y * std::sin(angle);
    corners.push_back(middle + Vec2{x * cosine - y * sine, x * sine + y * cosine});
  }
  polygon(corners, color);
}

}  // namespace game
