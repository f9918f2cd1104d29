// Presets of exports as JSON.
#include "native_exports.h"

#include <utility>

#include "native_members.h"

namespace talus {
namespace {

FormatResult<ExportPreset> take_preset(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  ExportPreset preset;
  take.text("name", kMaxExportText, preset.name);
  take.text("to", kMaxExportText, preset.exporter);
  take.text("path", kMaxExportText, preset.path);
  take.text("parts", kMaxExportText, preset.parts);
  take.optional("on_save", preset.on_save);
  preset.extra = take.rest();
  return take.result(std::move(preset));
}

FormatResult<Json> put_preset(const ExportPreset& preset, const std::string& path) {
  auto json = parse_extra(preset.extra);
  if (!json) return json;
  for (const auto& [key, text] :
       {std::pair{"name", &preset.name}, {"to", &preset.exporter}, {"path", &preset.path}}) {
    if (text->size() > kMaxExportText)
      return tl::unexpected(FormatError{"key " + path + "." + key, length_text(kMaxExportText)});
    (*json)[key] = *text;
  }
  if (preset.parts.size() > kMaxExportText)
    return tl::unexpected(FormatError{"key " + path + ".parts", length_text(kMaxExportText)});
  if (!preset.parts.empty()) (*json)["parts"] = preset.parts;
  if (preset.on_save) (*json)["on_save"] = true;
  return json;
}

}  // namespace

FormatResult<std::vector<ExportPreset>> take_exports(Json& list) {
  return take_list<ExportPreset>(list, "exports", take_preset, kMaxExports,
                                 "must be a list of up to 100 presets");
}

FormatResult<Json> json_of(const std::vector<ExportPreset>& exports) {
  return put_list(exports, "exports", put_preset);
}

}  // namespace talus
