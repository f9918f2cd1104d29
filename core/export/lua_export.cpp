// Folders of Lua: for any game, and a game for LÖVE.
#include <algorithm>

#include "../formats/pictures/png_picture.h"
#include "../formats/pictures/png_sheet.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_pictures.h"
#include "lua_runtime.h"

namespace talus {

FormatResult<Exported> export_lua_runtime(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, false);
  if (!runtime) return tl::unexpected(runtime.error());
  std::string level = lua_level(request.level, LuaForm::readable, request.progress, request.layered, nullptr,
                                &request.whole());
  const std::size_t code = runtime->size() + level.size();
  return with_license(request, {{{"talus.lua", std::move(*runtime)}, {"level.lua", std::move(level)}},
                                dropped_physics(request.level),
                                code});
}

void add_drawn_level(const ExportRequest& request, Exported& out) {
  const auto pictures = lua_pictures(request.drawn());
  out.files.push_back(
      {"level.lua", lua_level(request.level, LuaForm::readable, request.progress, request.layered,
                              pictures ? &*pictures : nullptr, &request.whole())});
  out.files.push_back({"sheet.png", write_clear_sheet(request.drawn(), SheetId::tiles)});
  const std::vector<Spawn>& spawns = request.level.spawns;
  const bool shows_sprites = std::any_of(spawns.begin(), spawns.end(), [](const Spawn& spawn) {
    return !spawn.picture.empty() && spawn.picture.sheet == SheetId::sprites;
  });
  if (shows_sprites)
    out.files.push_back({"sprites.png", write_clear_sheet(request.drawn(), SheetId::sprites)});
  if (pictures) {
    const SheetPicture& all = pictures->picture;
    out.files.push_back({"pictures.png", encode_png(all.width, all.height, 4, all.rgba.data())});
  } else if (has_pictures(request.drawn())) {
    out.dropped.emplace_back("the pictures of large tiles, objects and layers, which are too many");
  }
}

FormatResult<void> add_assets(const ExportRequest& request, std::initializer_list<std::string> assets,
                              Exported& out) {
  for (const std::string& asset : assets) {
    FormatResult<std::string> text = request.read_asset(asset);
    if (!text) return tl::unexpected(text.error());
    const bool is_starter = asset.starts_with("templates/");
    out.files.push_back({asset.substr(asset.rfind('/') + 1), std::move(*text), is_starter});
  }
  return {};
}

FormatResult<Exported> export_love(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, true);
  if (!runtime) return tl::unexpected(runtime.error());
  Exported out{{{"talus.lua", std::move(*runtime)}}, dropped_physics(request.level)};
  add_drawn_level(request, out);
  const auto added = add_assets(
      request,
      {"templates/love/main.lua", "templates/love/conf.lua", "templates/love/rules.lua", "templates/area.lua",
       "templates/camera.lua", "templates/controls.lua", "templates/curve_points.lua", "templates/frames.lua",
       "templates/pictures.lua", "templates/tile_bodies.lua", "templates/trace.lua"},
      out);
  if (!added) return tl::unexpected(added.error());
  return with_license(request, std::move(out));
}

}  // namespace talus
