// Keeps textures of the sheets, and uploads them again when they change.
#include "sheet_textures.h"

#include <SDL_opengl.h>

#include <vector>

namespace talus {
namespace {

std::vector<std::uint8_t> to_rgba(const Sheet& sheet, const Palette& palette, bool clear_zero) {
  const SheetLayout layout = sheet.layout();
  const int width = layout.columns * kCartTileSize, height = layout.rows() * kCartTileSize;
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell place{x / kCartTileSize, y / kCartTileSize};
      if (!layout.contains(place)) continue;  // the last row may be shorter
      const int tile = layout.tile_at(place);
      const int pixel = y % kCartTileSize * kCartTileSize + x % kCartTileSize;
      const std::uint8_t index =
          sheet.images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(pixel)];
      const Rgb color = palette[index];
      std::uint8_t* out = &rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x)) *
                                4];
      out[0] = color.r;
      out[1] = color.g;
      out[2] = color.b;
      out[3] = clear_zero && index == 0 ? 0 : 255;
    }
  }
  return rgba;
}

void upload(unsigned name, int width, int height, const std::vector<std::uint8_t>& rgba) {
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
}

// clear_zero: pixels of colour 0 are transparent, except those of a picture in true colour.
void upload(unsigned name, const Sheet& sheet, const Palette& palette, bool clear_zero) {
  if (sheet.picture != nullptr)
    return upload(name, sheet.picture->width, sheet.picture->height, sheet.picture->rgba);
  const SheetLayout layout = sheet.layout();
  upload(name, layout.columns * kCartTileSize, layout.rows() * kCartTileSize,
         to_rgba(sheet, palette, clear_zero));
}

}  // namespace

SheetTextures::SheetTextures() {
  glGenTextures(static_cast<GLsizei>(names_.size()), names_.data());
  for (unsigned name : names_) {
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
}

SheetTextures::~SheetTextures() { glDeleteTextures(static_cast<GLsizei>(names_.size()), names_.data()); }

void SheetTextures::update(const Session& session, Ui& ui) {
  const Level& level = session.level();
  const auto id = [&](std::size_t i) {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(names_[i]));
  };
  constexpr std::size_t kSheets = 2;
  const auto in_true_colour = [&](std::size_t sheet) { return level.sheets[sheet].picture != nullptr; };
  for (std::size_t i = 0; i < kSheets; ++i) {
    ui.sheets[i] = id(i);
    ui.clear_sheets[i] = id(in_true_colour(i) ? i : kSheets + i);
  }
  for (std::size_t i = 0; i < ui.layouts.size(); ++i) ui.layouts[i] = level.sheets[i].layout();
  if (revision_ == session.revision()) return;
  const auto painted = revision_ ? session.sheet_changes().tiles_since(*revision_) : std::nullopt;
  revision_ = session.revision();
  if (painted) return upload_painted(level, *painted);
  for (std::size_t i = 0; i < kSheets; ++i) {
    upload(names_[i], level.sheets[i], level.palette, false);
    if (!in_true_colour(i)) upload(names_[kSheets + i], level.sheets[i], level.palette, true);
  }
}

void SheetTextures::upload_painted(const Level& level, const std::vector<int>& tiles) const {
  if (tiles.empty()) return;
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  glBindTexture(GL_TEXTURE_2D, names_[0]);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, sheet.picture->width);
  for (const int tile : tiles) {
    const Cell place = sheet.layout().place_of(tile);
    const int x = place.x * size.width, y = place.y * size.height;
    glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    sheet.picture->at(x, y));
  }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void SheetTextures::show_preview(const Sheet& sheet, const Palette& palette, Ui& ui) {
  upload(names_[4], sheet, palette, false);
  ui.preview = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(names_[4]));
}

}  // namespace talus
