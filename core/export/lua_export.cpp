// Folders of Lua: for any game, and a game for LÖVE.
#include "../formats/png_sheet.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_runtime.h"

namespace talus {

FormatResult<Exported> export_lua_runtime(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, false);
  if (!runtime) return tl::unexpected(runtime.error());
  return Exported{{{"talus.lua", std::move(*runtime)}, {"level.lua", lua_level(request.level)}}, {}};
}

FormatResult<Exported> export_love(const ExportRequest& request) {
  FormatResult<std::string> runtime = lua_runtime(request, true);
  if (!runtime) return tl::unexpected(runtime.error());
  Exported out{{{"talus.lua", std::move(*runtime)},
                {"level.lua", lua_level(request.level)},
                {"sheet.png", write_png_part(request.level, PngPart::tiles)}},
               {}};
  for (const std::string name : {"main.lua", "conf.lua"}) {
    FormatResult<std::string> text = request.read_asset("templates/love/" + name);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({name, std::move(*text)});
  }
  return out;
}

}  // namespace talus
