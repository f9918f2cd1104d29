// Session: pictures of the sheets and of the palette, out and in.
#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/tic80/tic_png.h"
#include "session/session_impl.h"

namespace talus {
namespace {

// Of a picture that can only be that, a palette; else of the sheet that is shown, at the selection. Only what
// is larger than the sheet is cut off.
PngImportOptions first_options(const PngPicture& picture, const SpriteArea& area) {
  const int width = in_whole_tiles(picture.width), height = in_whole_tiles(picture.height);
  PngImportOptions options;
  options.fit = width > kSheetSide || height > kSheetSide ? PngFit::cut_off : PngFit::fill_up;
  if (picture.height == 1) {
    options.part = PngPart::palette;
    return options;
  }
  options.part = area.sheet == SheetId::tiles ? PngPart::tiles : PngPart::sprites;
  const int x = area.tiles.x * kTileSize, y = area.tiles.y * kTileSize;
  const bool fits = x + width <= kSheetSide && y + height <= kSheetSide;
  options.tile = fits ? area.tile_at(0, 0) : 0;
  return options;
}

}  // namespace

void Session::Impl::carry_out(const action::ExportPng& a) {
  const auto saved = write_file_atomic(a.path, write_png_part(level, a.part));
  message = saved ? Message{"Saved " + last_name(a.path) + ".", false}
                  : Message{to_string(saved.error(), a.path), true};
}

void Session::Impl::open_picture(const std::string& picture_path,
                                 const std::optional<action::OpenFile>& cart) {
  read_beside(picture_path, [this, picture_path, cart](const Progress& progress) -> FileReader::Finish {
    const auto bytes = read_file(picture_path, kMaxFileBytes, progress);
    if (cart && bytes && has_tic_cart(*bytes)) return [this, cart] { ask_before_discarding(*cart); };
    auto picture = std::make_shared<FormatResult<PngPicture>>(
        bytes ? read_png(*bytes) : FormatResult<PngPicture>(tl::unexpected(bytes.error())));
    return [this, picture_path, picture] { take_picture(picture_path, std::move(*picture)); };
  });
}

void Session::Impl::take_picture(const std::string& picture_path, FormatResult<PngPicture> picture) {
  if (!picture) {
    message = Message{to_string(picture.error(), picture_path), true};
    return;
  }
  const PngImportOptions options = first_options(*picture, choices.area);
  png_import = PngImport{picture_path, *std::move(picture), options, {}};
  png_import->plan = plan_png_import(level, png_import->picture, options);
}

void Session::Impl::carry_out(const action::SetPngImport& a) {
  if (!png_import) return;
  png_import->options = a.options;
  png_import->plan = plan_png_import(level, png_import->picture, a.options);
}

void Session::Impl::carry_out(const action::ApplyPngImport&) {
  if (!png_import || !png_import->plan) return;
  const PngImport import = *std::exchange(png_import, std::nullopt);
  carry_out(action::EditLevel{import.plan->edit});
  message = Message{"Imported " + last_name(import.path) + ".", false};
}

}  // namespace talus
