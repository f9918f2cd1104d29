// A folder for games with bump.lua: slopes as a response, the level, and an example for LÖVE.
#include "export_targets.h"
#include "lua_level.h"
#include "plain_data.h"

namespace talus {

FormatResult<Exported> export_bump(const ExportRequest& request) {
  Exported out;
  add_drawn_level(request, out);
  struct Copied {
    const char *name, *asset;
    bool is_starter = false;
  };
  constexpr Copied kCopied[] = {
      {"bump_slopes.lua", "runtime/bump_slopes.lua"}, {"main.lua", "templates/bump/main.lua", true},
      {"camera.lua", "templates/camera.lua"},         {"controls.lua", "templates/controls.lua"},
      {"frames.lua", "templates/frames.lua"},         {"pictures.lua", "templates/pictures.lua"},
      {"conf.lua", "templates/love/conf.lua", true}};
  for (const Copied& file : kCopied) {
    FormatResult<std::string> text = request.read_asset(file.asset);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({file.name, std::move(*text), file.is_starter});
  }
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
