// A folder with a small game in C++, which builds as it is with an installed Talus.
#include "export_targets.h"

namespace talus {

FormatResult<Exported> export_cpp(const ExportRequest& request) {
  FormatResult<WrittenLevel> level = find_format("native")->write(request.level, {});
  if (!level) return tl::unexpected(level.error());
  Exported out{{{"level.talus.json", std::move(level->bytes)}}, std::move(level->dropped)};
  for (const std::string name : {"CMakeLists.txt", "main.cpp"}) {
    FormatResult<std::string> text = request.read_asset("templates/cpp/" + name);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({name, std::move(*text), true});
  }
  return with_license(request, std::move(out));
}

}  // namespace talus
