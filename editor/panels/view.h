// View: the window's own state, apart from the session. Each folder of panels declares its own part of it;
// some of it is remembered between starts (platform/settings.h).
#pragma once

#include "panels/canvas/canvases_view.h"
#include "panels/commands/commands_view.h"
#include "panels/debugger/debugger_view.h"
#include "panels/files/files_view.h"
#include "panels/level/level_view.h"
#include "panels/preferences.h"
#include "panels/requests.h"
#include "panels/sprites/sprites_view.h"
#include "panels/tiles/shape_view.h"
#include "panels/tour/tour_view.h"
#include "panels/window/tab_places.h"
#include "panels/window/window_view.h"

namespace talus {

inline constexpr std::size_t kMaxLayouts = 20;

struct View {
  WindowView window;
  TourView tour;
  CommandsView commands;
  CanvasesView canvas;
  SpritesView sprites;
  ShapeView shape;
  LevelView level;
  DebuggerView debugger;
  FilesView files;
  Preferences preferences;
  std::vector<SavedLayout> layouts;  // at most kMaxLayouts
  Requests requests;                 // of panels to each other

  // Brings a cell of the map into sight, and outlines it.
  void show_on_map(Cell cell) {
    canvas.marked_cell = cell;
    requests.ask(request::ShowCell{cell});
  }
  void forget_level() {  // another level is open
    canvas.forget_level();
    debugger.forget_level();
    shape.forget_level();
    sprites.kept_tile = -1;
    requests.take<request::PutBreakpointAt>();
  }
};

}  // namespace talus
