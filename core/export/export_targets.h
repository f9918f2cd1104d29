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
// the map, the sheets and the palette are the cart's own. An error where the map does not fit a cart. Of a
// level that was a cart sounds, music and all other banks stay; its code and its binary are dropped.
FormatResult<Exported> export_tic_playable(const ExportRequest& request);
FormatResult<Exported> export_tic_text_playable(const ExportRequest& request);

// Folders: the Lua runtime with the level, and games for LÖVE and in C++ that play it.
FormatResult<Exported> export_lua_runtime(const ExportRequest& request);
FormatResult<Exported> export_love(const ExportRequest& request);
FormatResult<Exported> export_cpp(const ExportRequest& request);

// Plain data (see docs/export-data.md): one file of Lua or JSON, and a folder of tables.
FormatResult<Exported> export_lua(const ExportRequest& request);
FormatResult<Exported> export_json(const ExportRequest& request);
FormatResult<Exported> export_csv(const ExportRequest& request);

// A C99 header with the map, the flags, the floors, the bodies, the tuning and what finds the floor below a
// point. Curves are dropped.
FormatResult<Exported> export_c(const ExportRequest& request);

// A project of LDtk with the level as an IntGrid, tiles and entities, and the sheet beside it. Curves are
// dropped.
FormatResult<Exported> export_ldtk(const ExportRequest& request);

// The map as a picture, one pixel a px; and with its outline, its normals and its bodies.
FormatResult<Exported> export_png(const ExportRequest& request);
FormatResult<Exported> export_svg(const ExportRequest& request);

// A folder for games with bump.lua: slopes as one of its responses, the level, and an example for LÖVE.
// Curves are dropped.
FormatResult<Exported> export_bump(const ExportRequest& request);

// Maps of Tiled with their picture beside them (see formats/tiled/tiled_map.h): as JSON, as XML, and as the
// Lua that Simple Tiled Implementation and its plugin for bump.lua load. There a full tile has the property
// `collidable`, and other ground is in the layer "slopes", whose objects are the boxes that bump_slopes.lua
// adds for it: each is `collidable`, and where a line goes across it, it has `slope` ("floor" or "ceiling")
// with the heights `h0` and `h1` at its left and right side, in px from its bottom or top, and `one_way`
// where only the line stops. A map with more than a million of them is an error; curves are dropped.
FormatResult<Exported> export_tmj(const ExportRequest& request);
FormatResult<Exported> export_tmx(const ExportRequest& request);
FormatResult<Exported> export_sti(const ExportRequest& request);

}  // namespace talus
