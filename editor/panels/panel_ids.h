// The ids of panels that commands show or focus.
#pragma once

#include <string_view>

namespace talus::panel_id {

inline constexpr std::string_view kFlags = "flags";
inline constexpr std::string_view kColor = "color";
inline constexpr std::string_view kInspector = "inspector";
inline constexpr std::string_view kWhy = "why";
inline constexpr std::string_view kShape = "shape";
inline constexpr std::string_view kTile = "tile";
inline constexpr std::string_view kTuning = "tuning";
inline constexpr std::string_view kBrushes = "brushes";
inline constexpr std::string_view kProblems = "problems";
inline constexpr std::string_view kHistory = "history";
inline constexpr std::string_view kLayers = "layers";
inline constexpr std::string_view kFlagSearch = "flag_search";
inline constexpr std::string_view kInputRoll = "input_roll";
inline constexpr std::string_view kPlots = "plots";
inline constexpr std::string_view kBreakpoints = "breakpoints";
inline constexpr std::string_view kCompare = "compare";
inline constexpr std::string_view kReach = "reach";
inline constexpr std::string_view kSheet = "sheet";
inline constexpr std::string_view kPixels = "pixels";
inline constexpr std::string_view kCanvas = "canvas";
inline constexpr std::string_view kTransport = "transport";

}  // namespace talus::panel_id
