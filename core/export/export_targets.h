// The make functions of all exporters. See exporter.h.
#pragma once

#include "exporter.h"

namespace talus {

inline constexpr std::string_view kLicenseFile = "LICENSE-talus.txt";
// The same with the license of the code in it, as kLicenseFile: each file with code names that in its first
// line.
FormatResult<Exported> with_license(const ExportRequest& request, Exported exported);

// Formats that Talus also reads, and the sheets and the palette as pictures.
FormatResult<Exported> export_native(const ExportRequest& request);
FormatResult<Exported> export_tic(const ExportRequest& request);
FormatResult<Exported> export_tic_text(const ExportRequest& request);
FormatResult<Exported> export_tiles_png(const ExportRequest& request);
FormatResult<Exported> export_sprites_png(const ExportRequest& request);
FormatResult<Exported> export_palette_png(const ExportRequest& request);

// A cart whose code plays the level. The code has the runtime, the level's shapes, curves and bodies, and the
// drawing; map, sheets and palette are the cart's own. A map that does not fit a cart is an error. If the
// level came from a cart, its sounds, music and other banks stay; its code and binary are dropped.
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

// A C99 header with map, flags, floors, bodies and tuning, and a function that finds the floor below a point.
// Curves are dropped.
FormatResult<Exported> export_c(const ExportRequest& request);

// A project for LDtk: the level as an IntGrid, tiles and entities, with the sheet beside it. Curves are
// dropped.
FormatResult<Exported> export_ldtk(const ExportRequest& request);

// The map as a picture, one pixel for each px; and as a drawing with outline, normals and bodies.
FormatResult<Exported> export_png(const ExportRequest& request);
FormatResult<Exported> export_svg(const ExportRequest& request);

// A folder for games with bump.lua: slopes as a response, the level, and an example for LÖVE. Curves are
// dropped.
FormatResult<Exported> export_bump(const ExportRequest& request);

// Maps of Tiled with their picture beside them (see formats/tiled/tiled_map.h): as JSON, as XML, and as the
// Lua that Simple Tiled Implementation and its plugin for bump.lua load. In Lua a full tile has the property
// `collidable`, and other ground is in the layer "slopes", whose objects are the boxes that bump_slopes.lua
// adds. Each is `collidable`. One with a sloped line has `slope` ("floor" or "ceiling") and the heights `h0`
// and `h1` at its left and right side, in px from its bottom or top; and `one_way` if only the line stops.
// Each also has the flags of its cell, and `shape_conveyor` of a conveyor. A map with more than a million
// boxes is an error. Curves are dropped.
FormatResult<Exported> export_tmj(const ExportRequest& request);
FormatResult<Exported> export_tmx(const ExportRequest& request);
FormatResult<Exported> export_sti(const ExportRequest& request);

}  // namespace talus
