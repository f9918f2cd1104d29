// A folder for games with bump.lua: slopes as a response, the level, and an example for LÖVE.
#include "export_targets.h"
#include "lua_level.h"
#include "plain_data.h"

namespace talus {

FormatResult<Exported> export_bump(const ExportRequest& request) {
  Exported out;
  add_drawn_level(request, out);
  const auto added = add_assets(
      request,
      {"runtime/bump_slopes.lua", "templates/bump/main.lua", "templates/love/conf.lua", "templates/area.lua",
       "templates/camera.lua", "templates/controls.lua", "templates/frames.lua", "templates/pictures.lua"},
      out);
  if (!added) return tl::unexpected(added.error());
  if (const std::size_t curves = request.level.curves.size(); curves > 0)
    out.dropped.push_back(std::to_string(curves) + (curves == 1 ? " curve" : " curves") +
                          ", which bump does not know");
  if (const int conveyors = conveyor_tiles(request.level); conveyors > 0)
    out.dropped.push_back((conveyors == 1 ? std::string("what a conveyor does")
                                          : "what " + std::to_string(conveyors) + " conveyors do") +
                          " to bodies, which bump does not know");
  for (std::string& phrase : dropped_by_bump(request.level)) out.dropped.push_back(std::move(phrase));
  return with_license(request, std::move(out));
}

}  // namespace talus
