// Presets of exports as JSON.
#include "native_exports.h"

#include <optional>
#include <utility>

#include "native_objects.h"

namespace talus {
namespace {

constexpr const char* kNoText = "must be a string of up to 4096 bytes";

// Takes the members of one preset, and remembers its first error.
class PresetReader {
 public:
  PresetReader(Json& json, std::string path) : json_(json), path_(std::move(path)) {}

  void take_text(const char* key, std::string& out) {
    take(key, [&](const Json& value) {
      const bool good = value.is_string() && value.get_ref<const std::string&>().size() <= kMaxExportText;
      if (!good) return fail(key, kNoText);
      out = value.get<std::string>();
    });
  }

  void take_switch(const char* key, bool& out) {
    take(key, [&](const Json& value) {
      if (!value.is_boolean()) return fail(key, "must be true or false");
      out = value.get<bool>();
    });
  }

  const std::optional<FormatError>& error() const { return error_; }

 private:
  template <class Read>
  void take(const char* key, Read read) {
    const auto found = json_.find(key);
    if (found == json_.end()) return;
    read(*found);
    json_.erase(found);
  }

  void fail(const std::string& key, std::string message) {
    if (!error_) error_ = FormatError{"key " + path_ + "." + key, std::move(message)};
  }

  Json& json_;
  std::string path_;
  std::optional<FormatError> error_;
};

FormatResult<ExportPreset> take_preset(Json& json, const std::string& path) {
  if (!json.is_object()) return tl::unexpected(FormatError{"key " + path, "must be an object"});
  ExportPreset preset;
  PresetReader reader(json, path);
  reader.take_text("name", preset.name);
  reader.take_text("to", preset.exporter);
  reader.take_text("path", preset.path);
  reader.take_switch("on_save", preset.on_save);
  if (reader.error()) return tl::unexpected(*reader.error());
  if (!json.empty()) preset.extra = json.dump();
  return preset;
}

}  // namespace

FormatResult<std::vector<ExportPreset>> take_exports(Json& list) {
  if (!list.is_array() || list.size() > kMaxExports)
    return tl::unexpected(FormatError{"key exports", "must be a list of up to 100 presets"});
  std::vector<ExportPreset> exports;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto preset = take_preset(list[i], "exports[" + std::to_string(i) + "]");
    if (!preset) return tl::unexpected(preset.error());
    exports.push_back(*std::move(preset));
  }
  return exports;
}

FormatResult<Json> json_of(const std::vector<ExportPreset>& exports) {
  Json list = Json::array();
  for (const ExportPreset& preset : exports) {
    auto json = parse_extra(preset.extra);
    if (!json) return json;
    for (const auto& [key, text] :
         {std::pair{"name", &preset.name}, {"to", &preset.exporter}, {"path", &preset.path}}) {
      if (text->size() > kMaxExportText) {
        const std::string place = "key exports[" + std::to_string(list.size()) + "]." + key;
        return tl::unexpected(FormatError{place, kNoText});
      }
      (*json)[key] = *text;
    }
    if (preset.on_save) (*json)["on_save"] = true;
    list.push_back(*std::move(json));
  }
  return list;
}

}  // namespace talus
