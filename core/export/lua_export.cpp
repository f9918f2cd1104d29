// Folders of Lua: for any game, and a game for LÖVE.
#include "../formats/pictures/png_sheet.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_runtime.h"

namespace talus {

FormatResult<Exported> export_lua_runtime(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, LuaForm::readable, false);
  if (!runtime) return tl::unexpected(runtime.error());
  std::string level = lua_level(request.level, LuaForm::readable, request.progress, request.layered);
  const std::size_t code = runtime->size() + level.size();
  return Exported{{{"talus.lua", std::move(*runtime)}, {"level.lua", std::move(level)}},
                  dropped_solver(request.level),
                  code};
}

FormatResult<Exported> export_love(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, LuaForm::readable, true);
  if (!runtime) return tl::unexpected(runtime.error());
  Exported out{{{"talus.lua", std::move(*runtime)},
                {"level.lua", lua_level(request.level, LuaForm::readable, request.progress, request.layered)},
                {"sheet.png", write_clear_tiles(request.drawn())}},
               dropped_solver(request.level)};
  for (const std::string name :
       {"love/main.lua", "love/conf.lua", "camera.lua", "curve_points.lua", "pictures.lua"}) {
    FormatResult<std::string> text = request.read_asset("templates/" + name);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({name.substr(name.find('/') + 1), std::move(*text), name.starts_with("love/")});
  }
  return out;
}

}  // namespace talus
