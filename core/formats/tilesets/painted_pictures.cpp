// Compares tiles, and patches pictures.
#include "painted_pictures.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "../../level/picture_tiles.h"
#include "../../level/tile_look.h"
#include "../files/atomic_file.h"
#include "../files/real_path.h"
#include "../pictures/png_patch.h"

namespace talus {
namespace {

// Whether a tile has another look than one of `before`, in colours of the same kind.
bool looks_otherwise(const Level& level, int tile, const Level& before, int old) {
  const Sheet &now = level.sheet(SheetId::tiles), &then = before.sheet(SheetId::tiles);
  if (now.picture == nullptr && then.picture == nullptr)
    return now.images[static_cast<std::size_t>(tile)] != then.images[static_cast<std::size_t>(old)];
  if (now.picture == then.picture && tile == old) return false;
  return shown_rgba(level, tile) != shown_rgba(before, old);
}

// Whether tiles of two levels show the same pixels of one file.
bool shows_same(const PictureTiles& a, const TileSource& in_a, const PictureTiles& b,
                const TileSource& in_b) {
  return in_a.file >= 0 && in_b.file >= 0 && in_a.shows_alike(in_b) &&
         a.files[static_cast<std::size_t>(in_a.file)].path ==
             b.files[static_cast<std::size_t>(in_b.file)].path;
}

// The tile of `before` that shows the same pixels of its file as a tile does now: usually that with the same
// number; -1: there is none.
int tile_before(int tile, const PictureTiles& now, const PictureTiles& before) {
  const TileSource source = now.of(tile);
  if (shows_same(now, source, before, before.of(tile))) return tile;
  const auto found = std::find_if(before.tiles.begin(), before.tiles.end(), [&](const TileSource& other) {
    return shows_same(now, source, before, other);
  });
  return found == before.tiles.end() ? -1 : static_cast<int>(found - before.tiles.begin());
}

// What a picture has to hold so that a pixel is shown with this colour. kind: of the picture.
std::array<std::uint8_t, 4> stored_color(const std::uint8_t* rgba, const PictureFile& file) {
  constexpr std::uint8_t kOpaque = 255;
  if (rgba[3] == 0 && file.transparent)
    return {file.transparent->r, file.transparent->g, file.transparent->b, kOpaque};
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

using PixelsByPath = std::map<std::string, std::map<std::pair<int, int>, std::array<std::uint8_t, 4>>>;

// The pixels of a tile that differ from `then`, by the paths of their pictures and their places, row by row.
// then: empty: all of them count.
void add_pixels(const Level& level, int tile, const std::vector<std::uint8_t>& then,
                const PictureTiles& pictures, PixelsByPath& pixels) {
  const TileSource source = pictures.of(tile);
  const TileSize size = level.map.tile_size();
  const std::vector<std::uint8_t> now = shown_rgba(level, tile);
  const PictureFile& file = pictures.files[static_cast<std::size_t>(source.file)];
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::size_t at = 4 * static_cast<std::size_t>(y * size.width + x);
      const auto pixel = source.pixel_at(x, y);
      if (!pixel || (!then.empty() && std::equal(&now[at], &now[at] + 4, &then[at]))) continue;
      pixels[file.path][{pixel->y, pixel->x}] = stored_color(&now[at], file);
    }
  }
}

FormatResult<std::string> patched(const std::string& path,
                                  const std::map<std::pair<int, int>, std::array<std::uint8_t, 4>>& pixels) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  std::vector<PngPixel> list;
  list.reserve(pixels.size());
  for (const auto& [place, rgba] : pixels) list.push_back({{place.second, place.first}, rgba});
  return patch_png(*bytes, list);
}

}  // namespace

FormatResult<std::vector<WrittenFile>> painted_pictures(const Level& level, const Level& before) {
  std::vector<WrittenFile> files;
  if (level.map.tile_size() != before.map.tile_size()) return files;
  const auto known = picture_tiles_of(level);
  const PictureTiles& pictures = *known;
  const bool has_same_numbers = (level.tiled && !before.tiled) || (level.ldtk && !before.ldtk);
  const auto old = has_same_numbers ? known : picture_tiles_of(before);
  PixelsByPath pixels;
  for (int tile = 0; tile < std::min(static_cast<int>(pictures.tiles.size()), level.tile_count()); ++tile) {
    if (pictures.of(tile).file < 0) continue;
    const int then = tile_before(tile, pictures, *old);
    if (then < 0 || then >= before.tile_count())
      add_pixels(level, tile, {}, pictures, pixels);
    else if (looks_otherwise(level, tile, before, then))
      add_pixels(level, tile, shown_rgba(before, then), pictures, pixels);
  }
  for (const auto& [path, of_file] : pixels) {
    auto bytes = patched(path, of_file);
    if (!bytes) {
      bytes.error().message = last_name(path) + ", a picture of its tiles: " + bytes.error().message;
      return tl::unexpected(bytes.error());
    }
    files.push_back({path, *std::move(bytes)});
  }
  return files;
}

Level without_painted_tiles(Level level, const Level& before) {
  const auto pictures = picture_tiles_of(level);
  Sheet& sheet = level.sheet(SheetId::tiles);
  const Sheet& old = before.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  if ((sheet.picture == nullptr) != (old.picture == nullptr) || before.map.tile_size() != size) return level;
  for (int tile = 0; tile < std::min(sheet.count(), old.count()); ++tile) {
    if (pictures->of(tile).file < 0) continue;
    const TileLook look = look_of(old, size, tile);
    if (look_of(sheet, size, tile) != look) put_look(look, size, tile, sheet);
  }
  return level;
}

}  // namespace talus
