// What each exporter writes. See exporter.h.
#pragma once

#include "exporter.h"

namespace talus {

// The formats that Talus reads back, and the sheets and the palette as pictures.
FormatResult<Exported> export_native(const ExportRequest& request);
FormatResult<Exported> export_tic(const ExportRequest& request);
FormatResult<Exported> export_tic_text(const ExportRequest& request);
FormatResult<Exported> export_tiles_png(const ExportRequest& request);
FormatResult<Exported> export_sprites_png(const ExportRequest& request);
FormatResult<Exported> export_palette_png(const ExportRequest& request);

// A cart whose code plays the level: the runtime, the level's shapes, curves and bodies, and what draws them;
// the map, the sheets and the palette are the cart's own. An error where the map does not fit a cart. Its own
// code, if it was a cart, is not kept.
FormatResult<Exported> export_tic_playable(const ExportRequest& request);
FormatResult<Exported> export_tic_text_playable(const ExportRequest& request);

// Folders: the Lua runtime with the level, and a game for LÖVE that plays it.
FormatResult<Exported> export_lua_runtime(const ExportRequest& request);
FormatResult<Exported> export_love(const ExportRequest& request);

}  // namespace talus
