// Every panel and its region.
#include "panel_list.h"

#include <cassert>

#include "help_panel.h"
#include "layouts_panel.h"
#include "menu_panel.h"
#include "message_panel.h"
#include "metrics_panel.h"
#include "panels/canvas/canvas_panel.h"
#include "panels/commands/command_palette_panel.h"
#include "panels/commands/keys_panel.h"
#include "panels/debugger/breakpoints_panel.h"
#include "panels/debugger/compare_panel.h"
#include "panels/debugger/input_roll_panel.h"
#include "panels/debugger/plots_panel.h"
#include "panels/debugger/timeline_panel.h"
#include "panels/debugger/transport_panel.h"
#include "panels/debugger/tuning_panel.h"
#include "panels/debugger/why_panel.h"
#include "panels/files/export_panel.h"
#include "panels/files/level_import_panel.h"
#include "panels/files/picture_import_panel.h"
#include "panels/files/reading_panel.h"
#include "panels/inspector/inspector_panel.h"
#include "panels/level/background_panel.h"
#include "panels/level/delete_group_panel.h"
#include "panels/level/find_tiles_panel.h"
#include "panels/level/history_panel.h"
#include "panels/level/layers_panel.h"
#include "panels/level/new_level_panel.h"
#include "panels/level/problems_panel.h"
#include "panels/level/reach_panel.h"
#include "panels/level/resize_panel.h"
#include "panels/level/tile_import_panel.h"
#include "panels/sprites/color_panel.h"
#include "panels/sprites/palette_panel.h"
#include "panels/sprites/pixel_panel.h"
#include "panels/sprites/sheet_panel.h"
#include "panels/tiles/brushes_panel.h"
#include "panels/tiles/flag_search_panel.h"
#include "panels/tiles/flags_panel.h"
#include "panels/tiles/shape_panel.h"
#include "panels/tiles/tile_panel.h"
#include "panels/tour/tour_panel.h"
#include "question_panel.h"
#include "settings_panel.h"
#include "status_panel.h"
#include "welcome_panel.h"

namespace talus {
namespace {

template <class P>
PanelPlace place(Region region) {
  return {std::make_unique<P>(), region};
}

}  // namespace

std::vector<PanelPlace> make_panels() {
  std::vector<PanelPlace> panels;
  panels.push_back(place<MenuPanel>(Region::menu));
  panels.push_back(place<SheetPanel>(Region::sheet));
  panels.push_back(place<PixelPanel>(Region::pixels));
  panels.push_back(place<PalettePanel>(Region::palette));
  panels.push_back(place<FlagsPanel>(Region::flags));
  panels.push_back(place<ColorPanel>(Region::flags));
  panels.push_back(place<CanvasPanel>(Region::canvas));
  panels.push_back(place<InspectorPanel>(Region::right_top));
  panels.push_back(place<WhyPanel>(Region::right_top));
  panels.push_back(place<TuningPanel>(Region::right_top));
  panels.push_back(place<ShapePanel>(Region::right_top));
  panels.push_back(place<TilePanel>(Region::right_top));
  panels.push_back(place<BrushesPanel>(Region::right_top));
  panels.push_back(place<ProblemsPanel>(Region::right_bottom));
  panels.push_back(place<LayersPanel>(Region::right_bottom));
  panels.push_back(place<HistoryPanel>(Region::right_bottom));
  panels.push_back(place<FlagSearchPanel>(Region::right_bottom));
  panels.push_back(place<InputRollPanel>(Region::dock));
  panels.push_back(place<PlotsPanel>(Region::dock));
  panels.push_back(place<BreakpointsPanel>(Region::dock));
  panels.push_back(place<ComparePanel>(Region::dock));
  panels.push_back(place<ReachPanel>(Region::dock));
  panels.push_back(place<TimelinePanel>(Region::timeline));
  panels.push_back(place<TransportPanel>(Region::transport));
  panels.push_back(place<StatusPanel>(Region::status));
  panels.push_back(place<WelcomePanel>(Region::floating));
  panels.push_back(place<TourPanel>(Region::floating));
  panels.push_back(place<HelpPanel>(Region::floating));
  panels.push_back(place<MetricsPanel>(Region::floating));
  panels.push_back(place<SettingsPanel>(Region::floating));
  panels.push_back(place<LayoutsPanel>(Region::floating));
  panels.push_back(place<KeysPanel>(Region::floating));
  panels.push_back(place<FindTilesPanel>(Region::floating));
  panels.push_back(place<ExportPanel>(Region::floating));
  panels.push_back(place<ResizePanel>(Region::floating));
  panels.push_back(place<BackgroundPanel>(Region::floating));
  panels.push_back(place<DeleteGroupPanel>(Region::floating));
  panels.push_back(place<NewLevelPanel>(Region::floating));
  panels.push_back(place<CommandPalettePanel>(Region::floating));
  panels.push_back(place<PictureImportPanel>(Region::floating));
  panels.push_back(place<TileImportPanel>(Region::floating));
  panels.push_back(place<LevelImportPanel>(Region::floating));
  panels.push_back(place<ReadingPanel>(Region::floating));
  panels.push_back(place<QuestionPanel>(Region::floating));
  panels.push_back(place<MessagePanel>(Region::floating));
  return panels;
}

Region region_of_place(TabPlace place) {
  switch (place) {
    case TabPlace::left:
      return Region::flags;
    case TabPlace::right_top:
      return Region::right_top;
    case TabPlace::right_bottom:
      return Region::right_bottom;
    default:
      return Region::dock;
  }
}

std::optional<TabPlace> place_of_region(Region region) {
  for (const TabPlace place : {TabPlace::left, TabPlace::right_top, TabPlace::right_bottom, TabPlace::dock})
    if (region_of_place(place) == region) return place;
  return std::nullopt;
}

bool is_open_at(const WindowView& window, TabPlace place) {
  assert(place != TabPlace::closed);
  if (place == TabPlace::left) return window.left_open;
  if (place == TabPlace::dock) return window.dock_open;
  return window.right_open && (place == TabPlace::right_top || window.right_low_open);
}

void open_place(WindowView& window, TabPlace place) {
  assert(place != TabPlace::closed);
  if (place == TabPlace::left)
    window.left_open = true;
  else if (place == TabPlace::dock)
    window.dock_open = true;
  else
    window.right_open = true;
  if (place == TabPlace::right_bottom) window.right_low_open = true;
}

bool has_tabs(Region region) { return place_of_region(region).has_value(); }

const std::vector<TabInfo>& tab_infos() {
  static const std::vector<TabInfo> kTabs = [] {
    std::vector<TabInfo> tabs;
    for (const auto& [panel, region] : make_panels())
      if (const auto place = place_of_region(region))
        tabs.push_back({std::string(panel->id()), std::string(panel->title()), *place});
    return tabs;
  }();
  return kTabs;
}

}  // namespace talus
