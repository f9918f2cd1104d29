// The table of the settings, and their file.
#include "settings.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/files/atomic_file.h"
#include "formats/text/json_text.h"
#include "former_names.h"
#include "preferences_fields.h"
#include "user_folder.h"

namespace talus {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// Heights and widths, as shares of the region that they divide.
Fields<Layout> layout_fields() {
  const auto share = [](const char* key, double Layout::*member) {
    return number(key, member, Layout().*member, 0.05, 0.95);
  };
  return {share("left", &Layout::left),
          share("right", &Layout::right),
          share("sheet", &Layout::sheet),
          share("pixels", &Layout::pixels),
          share("right_split", &Layout::right_split),
          share("canvas_split", &Layout::canvas_split),
          share("dock", &Layout::dock)};
}

Fields<MovedTab> moved_tab_fields() {
  return {text("panel", &MovedTab::panel), choice("place", &MovedTab::place, TabPlace::closed,
                                                  {"left", "right_top", "right_bottom", "dock", "closed"})};
}

const std::vector<std::string>& canvas_names() {
  static const std::vector<std::string> kNames = {"map", "play", "both", "two_maps"};
  return kNames;
}

Fields<SavedLayout> saved_layout_fields() {
  return {text("name", &SavedLayout::name),
          object("sizes", &SavedLayout::sizes, layout_fields()),
          choice("canvas", &SavedLayout::canvas, CanvasMode::play, canvas_names()),
          toggle("left_column", &SavedLayout::left_open, true),
          toggle("right_column", &SavedLayout::right_open, true),
          toggle("right_column_below", &SavedLayout::right_low_open, true),
          toggle("debugger", &SavedLayout::dock_open, false),
          texts("tabs", &SavedLayout::tabs, kMaxTabs),
          objects("moved_tabs", &SavedLayout::moved_tabs, moved_tab_fields(), "panel", kMaxTabs)};
}

Fields<Breakpoint> breakpoint_fields() {
  return {text("condition", &Breakpoint::condition), number("body", &Breakpoint::body, 0, 0, 1e9),
          number("count", &Breakpoint::count, 1, 1, 1e9),
          toggle("each_frame", &Breakpoint::each_frame, false),
          toggle("enabled", &Breakpoint::enabled, true)};
}

// The overlays that are on, by their keys; unknown keys are left out.
Field<Settings> overlays_field(const char* key) {
  json standard = json::array();
  for (const Overlay* overlay : all_overlays())
    if (overlay->is_default) standard.push_back(overlay->key);
  return {key, standard, [](const json& v) { return v.is_array(); },
          [](Settings& s, const json& list) {
            s.overlays = {};
            for (const json& v : list)
              if (const Overlay* overlay = v.is_string() ? find_overlay(v.get<std::string>()) : nullptr)
                s.overlays.set(*overlay, true);
          },
          [](const Settings& s) {
            json list = json::array();
            for (const Overlay* overlay : all_overlays())
              if (s.overlays.has(*overlay)) list.push_back(overlay->key);
            return list;
          }};
}

// A new setting is a row here and a member of Settings.
const Fields<Settings>& settings_fields() {
  static const Fields<Settings> kFields = {
      number("width", &Settings::width, 0, 320, 16384),
      number("height", &Settings::height, 0, 320, 16384),
      object("layout", &Settings::layout, layout_fields()),
      choice("canvas", &Settings::canvas, CanvasMode::play, canvas_names()),
      number("ui_scale", &Settings::ui_scale, 0, 1, 4),
      toggle("grid", &Settings::grid, true),
      toggle("screen_borders", &Settings::screen_borders, true),
      of_part(&Settings::pixels, toggle("pixel_neighbours", &PixelView::neighbours, false)),
      of_part(&Settings::pixels, toggle("pixels_enlarged", &PixelView::enlarged, false)),
      of_part(&Settings::pixels, toggle("pixels_unfolded", &PixelView::unfolded, false)),
      overlays_field("overlays"),
      texts("recent_files", &Settings::recent_files, kMaxRecentFiles),
      texts("kept_folders", &Settings::kept_folders, kMaxKeptFolders),
      texts("tabs", &Settings::tabs, kMaxTabs),
      objects("moved_tabs", &Settings::moved_tabs, moved_tab_fields(), "panel", kMaxTabs),
      objects("layouts", &Settings::layouts, saved_layout_fields(), "name", kMaxLayouts),
      toggle("left_column", &Settings::left_open, true),
      toggle("right_column", &Settings::right_open, true),
      toggle("right_column_below", &Settings::right_low_open, true),
      toggle("debugger", &Settings::dock_open, false),
      toggle("legend_folded", &Settings::legend_folded, false),
      toggle("labels_all", &Settings::labels_all, false),
      objects("breakpoints", &Settings::breakpoints, breakpoint_fields(), "condition", kMaxBreakpoints),
      texts("plots", &Settings::plots, kMaxPlots),
      choice("overlay_palette", &Settings::overlay_palette, OverlayPalette::standard,
             {"standard", "colour_blind"}),
      number("tour_step", &Settings::tour_step, 0, 0, 100),
      object("preferences", &Settings::preferences, preferences_fields()),
  };
  return kFields;
}

}  // namespace

Settings default_settings() {
  Settings settings;
  read_fields(settings_fields(), json::object(), settings);
  return settings;
}

std::string first_file(const Settings& settings) {
  if (settings.preferences.starts_with != StartsWith::last_level || settings.recent_files.empty()) return "";
  std::error_code error;
  const std::string& last = settings.recent_files.front();
  return fs::exists(last, error) ? last : "";
}

std::string settings_path() { return (fs::path(config_folder()) / "settings.json").string(); }

FormatResult<Settings> settings_of_text(std::string_view text) {
  auto root = parse_json(text);
  if (!root) return tl::unexpected(root.error());
  if (!root->is_object()) return tl::unexpected(FormatError{"", "is JSON, but not settings"});
  rename_former(*root);
  Settings settings;
  read_fields(settings_fields(), *root, settings);
  return settings;
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
  // A file name need not be UTF-8; other bytes are replaced, so that nothing is thrown.
  const std::string text =
      written_fields(settings_fields(), settings).dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  if (const auto written = write_file_atomic(path, text); !written)
    return tl::unexpected("The settings cannot be saved: " + to_string(written.error(), path));
  return {};
}

}  // namespace talus
