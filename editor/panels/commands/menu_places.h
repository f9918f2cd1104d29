// The sections of the menus in the menu bar. Each row of the table of commands may name one of them.
#pragma once

#include <array>
#include <string_view>

namespace talus {

// The menus of the menu bar, from left to right.
inline constexpr std::array<std::string_view, 8> kMenus = {"File", "Edit", "Map",   "Sprites",
                                                           "View", "Play", "Debug", "Help"};

// A section of a menu. Lines separate the sections. Within a section, commands are in the order of the table.
struct MenuPlace {
  std::string_view menu = {};  // "Map", or "Debug/Timeline" for a menu within a menu; empty: no menu
  int section = 0;             // from 0 at the top
  friend bool operator==(const MenuPlace&, const MenuPlace&) = default;
};

namespace menus {

inline constexpr MenuPlace kFileOpen{"File", 0}, kFileSave{"File", 1}, kFilePrograms{"File", 2},
    kFileExport{"File", 3}, kFilePictures{"File", 4}, kFileQuit{"File", 5};

inline constexpr MenuPlace kEditUndo{"Edit", 0}, kEditShape{"Edit", 1}, kEditFlags{"Edit", 2},
    kEditProblems{"Edit", 3}, kEditSettings{"Edit", 4};

inline constexpr MenuPlace kMapSelection{"Map", 0}, kMapSearch{"Map", 1};
inline constexpr MenuPlace kMapTools{"Map/Tools", 0}, kMapBrushes{"Map/Brushes", 0};
inline constexpr MenuPlace kLayerChoice{"Map/Layers", 0}, kLayerChanges{"Map/Layers", 1},
    kLayerSwitches{"Map/Layers", 2};

inline constexpr MenuPlace kSpritesSelection{"Sprites", 0}, kSpritesTools{"Sprites", 1},
    kSpritesChanges{"Sprites", 2}, kSpritesPalette{"Sprites", 3}, kSpritesView{"Sprites", 4};

inline constexpr MenuPlace kViewFocus{"View", 0}, kViewCanvases{"View", 1}, kViewZoom{"View", 2},
    kViewMarks{"View", 3}, kViewLayouts{"View", 4}, kViewLooks{"View", 5};

inline constexpr MenuPlace kPlayRun{"Play", 0}, kPlaySpeed{"Play", 1}, kPlayBody{"Play", 2},
    kPlayOverlays{"Play", 3};

inline constexpr MenuPlace kDebugPanels{"Debug", 0}, kDebugStages{"Debug", 1}, kDebugRecording{"Debug", 2};
inline constexpr MenuPlace kTimelineSeek{"Debug/Timeline", 0}, kTimelineMarks{"Debug/Timeline", 1},
    kTimelineZoom{"Debug/Timeline", 2};
inline constexpr MenuPlace kBranches{"Debug/Branches", 0}, kBranchesRerun{"Debug/Branches", 1};
inline constexpr MenuPlace kBreakpointsRun{"Debug/Breakpoints", 0}, kBreakpointsNew{"Debug/Breakpoints", 1},
    kBreakpointsSwitch{"Debug/Breakpoints", 2};
inline constexpr MenuPlace kCompare{"Debug/Compare", 0}, kCompareParting{"Debug/Compare", 1};
inline constexpr MenuPlace kPlots{"Debug/Plots", 0}, kReach{"Debug/Reach", 0}, kTuning{"Debug/Tuning", 0};

inline constexpr MenuPlace kHelp{"Help", 0};

}  // namespace menus
}  // namespace talus
