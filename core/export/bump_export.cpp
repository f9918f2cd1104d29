// A folder for games with bump.lua: slopes as a response, the level, and an example for LÖVE.
#include "../formats/png_sheet.h"
#include "export_targets.h"
#include "lua_level.h"

namespace talus {

FormatResult<Exported> export_bump(const ExportRequest& request) {
  Exported out;
  out.files = {{"level.lua", lua_level(request.level)},
               {"sheet.png", write_png_part(request.level, PngPart::tiles)}};
  constexpr std::pair<const char*, const char*> kCopied[] = {{"bump_slopes.lua", "runtime/bump_slopes.lua"},
                                                             {"main.lua", "templates/bump/main.lua"},
                                                             {"camera.lua", "templates/camera.lua"},
                                                             {"conf.lua", "templates/love/conf.lua"}};
  for (const auto& [name, asset] : kCopied) {
    FormatResult<std::string> text = request.read_asset(asset);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({name, std::move(*text)});
  }
  if (const std::size_t curves = request.level.curves.size(); curves > 0)
    out.dropped.push_back(std::to_string(curves) + (curves == 1 ? " curve" : " curves") +
                          ", which bump does not know");
  return out;
}

}  // namespace talus
