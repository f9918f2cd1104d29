// A folder with a small game in C++, which builds as it is with an installed Talus and SDL2.
#include "export_targets.h"

namespace talus {
namespace {

constexpr std::string_view kLevelFile = "level.talus.json";

}  // namespace

FormatResult<Exported> export_cpp(const ExportRequest& request) {
  FormatResult<WrittenLevel> level = find_format("native")->write(request.level, {});
  if (!level) return tl::unexpected(level.error());
  Exported out{{{std::string(kLevelFile), std::move(level->bytes)}}, std::move(level->dropped)};
  for (const std::string_view name : find_exporter("cpp")->beside) {
    if (name == kLevelFile || name == kLicenseFile) continue;
    FormatResult<std::string> text = request.read_asset("templates/cpp/" + std::string(name));
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({std::string(name), std::move(*text), true});
  }
  return with_license(request, std::move(out));
}

}  // namespace talus
