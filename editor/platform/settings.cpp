// The settings as JSON. A value out of range gets its default; a file that is no JSON object is an error.
#include "settings.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/files/atomic_file.h"
#include "formats/text/json_text.h"
#include "preferences_json.h"
#include "user_folder.h"

namespace talus {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kCanvasNames = {"map", "play", "both",
                                                          "two_maps"};  // by CanvasMode

constexpr const char* kColourBlind = "colour_blind";

struct LayoutField {
  const char* key;
  double Layout::*value;
};
constexpr std::array<LayoutField, 7> kLayoutFields = {{{"left", &Layout::left},
                                                       {"right", &Layout::right},
                                                       {"sheet", &Layout::sheet},
                                                       {"pixels", &Layout::pixels},
                                                       {"right_split", &Layout::right_split},
                                                       {"canvas_split", &Layout::canvas_split},
                                                       {"dock", &Layout::dock}}};

// Sets `value` if the object has a number of that name in the range.
template <class T>
void read_number(const json& object, const char* key, double min, double max, T& value) {
  const auto it = object.find(key);
  if (it == object.end() || !it->is_number()) return;
  const double number = it->get<double>();
  if (number >= min && number <= max) value = static_cast<T>(number);
}

void read_bool(const json& object, const char* key, bool& value) {
  const auto it = object.find(key);
  if (it != object.end() && it->is_boolean()) value = it->get<bool>();
}

// The strings of an array; nothing for anything else.
std::vector<std::string> read_strings(const json& object, const char* key) {
  std::vector<std::string> strings;
  const auto it = object.find(key);
  if (it == object.end() || !it->is_array()) return strings;
  for (const json& item : *it)
    if (item.is_string()) strings.push_back(item.get<std::string>());
  return strings;
}

std::vector<Breakpoint> read_breakpoints(const json& object) {
  std::vector<Breakpoint> breakpoints;
  const auto it = object.find("breakpoints");
  if (it == object.end() || !it->is_array()) return breakpoints;
  for (const json& item : *it) {
    if (!item.is_object() || breakpoints.size() == kMaxBreakpoints) continue;
    const auto condition = item.find("condition");
    if (condition == item.end() || !condition->is_string()) continue;
    Breakpoint& b = breakpoints.emplace_back();
    b.condition = condition->get<std::string>();
    read_number(item, "body", 0, 1e9, b.body);
    read_number(item, "count", 1, 1e9, b.count);
    read_bool(item, "each_frame", b.each_frame);
    read_bool(item, "enabled", b.enabled);
  }
  return breakpoints;
}

json to_json(const std::vector<Breakpoint>& breakpoints) {
  json list = json::array();
  for (const Breakpoint& b : breakpoints)
    list.push_back({{"condition", b.condition},
                    {"body", b.body},
                    {"count", b.count},
                    {"each_frame", b.each_frame},
                    {"enabled", b.enabled}});
  return list;
}

Settings from_json(const json& root) {
  Settings s = default_settings();
  read_number(root, "width", 320, 16384, s.width);
  read_number(root, "height", 320, 16384, s.height);
  if (const auto it = root.find("layout"); it != root.end() && it->is_object())
    for (const LayoutField& field : kLayoutFields)
      read_number(*it, field.key, 0.05, 0.95, s.layout.*field.value);
  for (std::size_t i = 0; i < kCanvasNames.size(); ++i)
    if (root.contains("canvas") && root["canvas"] == kCanvasNames[i]) s.canvas = static_cast<CanvasMode>(i);
  read_number(root, "ui_scale", 1, 4, s.ui_scale);
  read_bool(root, "grid", s.grid);
  read_bool(root, "screen_borders", s.screen_borders);
  read_bool(root, "pixel_neighbours", s.pixels.neighbours);
  read_bool(root, "pixels_enlarged", s.pixels.enlarged);
  if (root.contains("overlays")) {
    s.overlays = {};
    for (const std::string& key : read_strings(root, "overlays"))
      if (const auto id = find_overlay(key)) s.overlays.set(*id, true);
  }
  s.recent_files = read_strings(root, "recent_files");
  if (s.recent_files.size() > kMaxRecentFiles) s.recent_files.resize(kMaxRecentFiles);
  s.tabs = read_strings(root, "tabs");
  if (s.tabs.size() > kMaxTabs) s.tabs.resize(kMaxTabs);
  read_bool(root, "debugger", s.dock_open);
  read_bool(root, "legend_folded", s.legend_folded);
  s.breakpoints = read_breakpoints(root);
  s.watches = read_strings(root, "watches");
  if (s.watches.size() > kMaxWatches) s.watches.resize(kMaxWatches);
  if (root.contains("overlay_palette") && root["overlay_palette"] == kColourBlind)
    s.overlay_palette = OverlayPalette::colour_blind;
  if (root.contains("preferences")) s.preferences = preferences_of_json(root["preferences"]);
  return s;
}

json to_json(const Settings& s) {
  json layout = json::object(), overlays = json::array();
  for (const LayoutField& field : kLayoutFields) layout[field.key] = s.layout.*field.value;
  for (const OverlayInfo& info : overlay_infos())
    if (s.overlays.has(info.id)) overlays.push_back(info.key);
  return {{"width", s.width},
          {"height", s.height},
          {"layout", layout},
          {"canvas", kCanvasNames[static_cast<std::size_t>(s.canvas)]},
          {"ui_scale", s.ui_scale},
          {"grid", s.grid},
          {"screen_borders", s.screen_borders},
          {"pixel_neighbours", s.pixels.neighbours},
          {"pixels_enlarged", s.pixels.enlarged},
          {"overlays", overlays},
          {"recent_files", s.recent_files},
          {"tabs", s.tabs},
          {"debugger", s.dock_open},
          {"legend_folded", s.legend_folded},
          {"breakpoints", to_json(s.breakpoints)},
          {"watches", s.watches},
          {"overlay_palette", s.overlay_palette == OverlayPalette::colour_blind ? kColourBlind : "standard"},
          {"preferences", to_json(s.preferences)}};
}

}  // namespace

Settings default_settings() {
  Settings settings;
  for (OverlayId id :
       {OverlayId::normals, OverlayId::velocity, OverlayId::slope_delta, OverlayId::floor_height})
    settings.overlays.set(id, true);
  return settings;
}

std::string settings_path() { return (fs::path(config_folder()) / "settings.json").string(); }

FormatResult<Settings> settings_of_text(std::string_view text) {
  const auto root = parse_json(text);
  if (!root) return tl::unexpected(root.error());
  if (!root->is_object()) return tl::unexpected(FormatError{"", "is JSON, but not settings"});
  return from_json(*root);
}

tl::expected<Settings, std::string> load_settings(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return default_settings();
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected("The settings are ignored: " + to_string(bytes.error(), path));
  auto settings = settings_of_text(*bytes);
  if (!settings) return tl::unexpected("The settings are ignored: " + to_string(settings.error(), path));
  return *std::move(settings);
}

tl::expected<void, std::string> save_settings(const Settings& settings, const std::string& path) {
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  // A file name need not be UTF-8; what is not is replaced rather than thrown over.
  const std::string text = to_json(settings).dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  if (const auto written = write_file_atomic(path, text); !written)
    return tl::unexpected("The settings cannot be saved: " + to_string(written.error(), path));
  return {};
}

}  // namespace talus
