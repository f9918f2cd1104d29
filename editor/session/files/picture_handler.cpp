// Imports and exports pictures of the sheets and of the palette.
#include "picture_handler.h"

#include <memory>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/tic80/tic_png.h"

namespace talus {
namespace {

// The part that a picture becomes: the palette if it can be nothing else, or else the shown sheet, at the
// selection. Only a picture that is larger than the sheet is cut off.
PngImportOptions first_options(const Level& level, const PngPicture& picture, const SpriteArea& area) {
  const int width = in_whole_tiles(picture.width), height = in_whole_tiles(picture.height);
  const SheetLayout sheet = level.sheet(area.sheet).layout();
  const int room_x = sheet.columns * kCartTileSize, room_y = sheet.rows() * kCartTileSize;
  PngImportOptions options;
  options.fit = width > room_x || height > room_y ? PngFit::cut_off : PngFit::fill_up;
  if (picture.height == 1) {
    options.part = PngPart::palette;
    return options;
  }
  options.part = area.sheet == SheetId::tiles ? PngPart::tiles : PngPart::sprites;
  const int x = area.tiles.x * kCartTileSize, y = area.tiles.y * kCartTileSize;
  const bool fits = x + width <= room_x && y + height <= room_y;
  options.tile = fits ? area.tile_at(level, 0, 0) : 0;
  return options;
}

// Whether a picture is likelier to be cut into tiles of its own than to be drawn on a sheet. One row of
// pixels is a palette.
bool is_for_tiles(const Sheet& sheet, const PngPicture& picture) {
  const SheetLayout layout = sheet.layout();
  const bool fits =
      picture.width <= layout.columns * kCartTileSize && picture.height <= layout.rows() * kCartTileSize;
  return picture.height > 1 && (sheet.picture || !fits);
}

}  // namespace

template <>
void PictureHandler::carry_out(const action::ExportPng& a) {
  if (const auto saved = write_file_atomic(a.path, write_png_part(open_.level, a.part)))
    messages_.tell("Saved " + last_name(a.path) + ".");
  else
    messages_.tell_error(to_string(saved.error(), a.path));
}

template <>
void PictureHandler::carry_out(const action::OpenPng& a) {
  open(a.path, {});
}

template <>
void PictureHandler::carry_out(const action::SetPngImport& a) {
  if (!png_import_) return;
  png_import_->options = a.options;
  png_import_->plan = plan_png_import(open_.level, png_import_->picture, a.options);
}

template <>
void PictureHandler::carry_out(const action::ApplyPngImport&) {
  if (!png_import_ || !png_import_->plan) return;
  const PngImport import = *std::exchange(png_import_, std::nullopt);
  level_.edit_by_user(import.plan->edit);
  messages_.tell("Imported " + last_name(import.path) + ".");
}

template <>
void PictureHandler::carry_out(const action::CancelPngImport&) {
  png_import_.reset();
}

void PictureHandler::apply(const PictureAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void PictureHandler::open(const std::string& path, const Instead& instead) {
  reading_.read(path, [this, path, instead](const Progress& progress) -> FileReader::Finish {
    const auto bytes = read_file(path, kMaxFileBytes, progress);
    if (instead.cart && bytes && has_tic_cart(*bytes)) return instead.cart;
    auto picture = std::make_shared<FormatResult<PngPicture>>(
        bytes ? read_png(*bytes) : FormatResult<PngPicture>(tl::unexpected(bytes.error())));
    return [this, path, picture, instead] { take(path, std::move(*picture), instead); };
  });
}

void PictureHandler::take(const std::string& path, FormatResult<PngPicture> picture, const Instead& instead) {
  const Sheet& sheet = open_.level.sheet(SheetId::tiles);
  if (instead.tiles && (!picture || is_for_tiles(sheet, *picture))) return instead.tiles();
  if (!picture) return messages_.tell_error(to_string(picture.error(), path));
  const PngImportOptions options = first_options(open_.level, *picture, choices_.choices().area);
  png_import_ = PngImport{path, *std::move(picture), options, {}};
  png_import_->plan = plan_png_import(open_.level, png_import_->picture, options);
}

}  // namespace talus
