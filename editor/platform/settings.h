// Settings: what the program remembers between starts.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include <talus/formats/format.h>
#include "debug/breakpoint.h"
#include "overlay/overlay_table.h"
#include "panels/view.h"

namespace talus {

// settings.cpp has the default and the range of each.
struct Settings {
  int width{}, height{};  // px, of the window; 0: as the display allows
  Layout layout;
  CanvasMode canvas{};
  double ui_scale{};  // 0: automatic
  bool grid{};
  bool screen_borders{};
  PixelView pixels;
  OverlaySet overlays;                    // unknown names are left out
  std::vector<std::string> recent_files;  // at most kMaxRecentFiles
  std::vector<std::string> kept_folders;  // of the file dialog; at most kMaxKeptFolders
  std::vector<std::string> tabs;          // ids of panels; at most kMaxTabs, unknown ones do nothing
  std::vector<MovedTab> moved_tabs;       // at most kMaxTabs; unknown ids do nothing
  std::vector<SavedLayout> layouts;       // at most kMaxLayouts
  bool left_open{}, right_open{};         // the columns beside the canvas
  bool right_low_open{};                  // the lower part of the right one
  bool dock_open{};                       // the debugger's panels
  bool legend_folded{};                   // the overlays' legend has no names
  bool labels_all{};                      // the overlays label every body
  std::vector<Breakpoint> breakpoints;    // at most kMaxBreakpoints
  std::vector<std::string> plots;         // expressions; at most kMaxPlots
  OverlayPalette overlay_palette{};
  int tour_step{};  // of the tour inside the program, that comes next
  Preferences preferences;
};
inline constexpr std::size_t kMaxRecentFiles = 10, kMaxTabs = 16, kMaxBreakpoints = 64, kMaxPlots = 64;

// What a first start shows.
Settings default_settings();

// The file that a start without one opens; empty: the demo level.
std::string first_file(const Settings& settings);

// "settings.json" in config_folder().
std::string settings_path();

// An invalid value is left out; text that is no JSON object is an error.
FormatResult<Settings> settings_of_text(std::string_view text);
// The defaults when there is no such file; an error in one sentence when it cannot be read.
tl::expected<Settings, std::string> load_settings(const std::string& path);
tl::expected<void, std::string> save_settings(const Settings& settings, const std::string& path);

}  // namespace talus
