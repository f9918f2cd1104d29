// Formats that Talus also reads: levels, carts, sheets and palettes.
#include "../formats/pictures/png_sheet.h"
#include "cart_files.h"
#include "export_targets.h"

namespace talus {
namespace {

FormatResult<Exported> export_part(const ExportRequest& request, PngPart part) {
  return exported_file(write_png_part(request.level, part));
}

}  // namespace

FormatResult<Exported> export_native(const ExportRequest& request) {
  FormatResult<WrittenLevel> written = find_format("native")->write(request.level, {});
  if (!written) return tl::unexpected(written.error());
  return exported_file(std::move(written->bytes), std::move(written->dropped));
}
FormatResult<Exported> export_tic(const ExportRequest& request) { return tic_files(request, request.level); }
FormatResult<Exported> export_tic_text(const ExportRequest& request) {
  return tic_text_files(request, request.level);
}
FormatResult<Exported> export_tiles_png(const ExportRequest& request) {
  if (request.level.sheet(SheetId::tiles).picture != nullptr)
    return exported_file(write_map_tiles(request.level));
  return export_part(request, PngPart::tiles);
}
FormatResult<Exported> export_sprites_png(const ExportRequest& request) {
  return export_part(request, PngPart::sprites);
}
FormatResult<Exported> export_palette_png(const ExportRequest& request) {
  return export_part(request, PngPart::palette);
}

}  // namespace talus
