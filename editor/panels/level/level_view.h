// What the panels about the whole level show.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "edit/new_level.h"
#include "level/flag_search.h"
#include "level/lint/lint.h"

namespace talus {

// What the problems panel shows, besides the problems.
struct ProblemsView {
  const LintRule* kind = nullptr;  // the only listed rule; null: all rules
  std::optional<Problem> chosen;   // the problem that was gone to last
  std::size_t row = 0;             // its place in the list at that time
  // The list begins with what is nearest to this cell, in which the followed body is or stopped last;
  // nothing: it is in the order of the lint.
  std::optional<Cell> near;
  Cell body_cell;              // in which the followed body was last
  int frames_there = 0;        // draws of the panel for which it has been there
  std::string previewed;       // the fix that CanvasesView::fix_preview shows, of which revision
  std::string chosen_finding;  // message_of() the finding of a proof that was gone to last
};

// The group of layers that the panel of layers shows as chosen.
struct GroupChoice {
  int group = -1;    // index in TileLayers::groups; -1: none
  std::string name;  // of it; another one with that number is not the chosen one
};

struct LevelView {
  ProblemsView problems;
  GroupChoice group;             // what commands of layers work on; none: they work on the chosen layer
  int deleted_group = -1;        // the group of layers that a dialog asks about; -1: it is closed
  bool resize_open = false;      // the dialog of the map's size
  bool background_open = false;  // the dialog of the map's background
  bool new_level_open = false;   // the dialog of a new level's size
  NewContent new_content = {.plays = true};  // what new levels begin with
  bool find_tiles_open = false;              // the window that finds and replaces tiles
  int find_tile = 0;                         // of the level, the tile that it finds
  int replace_tile = 0;                      // of the level, the tile that replaces it
  // The layers in which cells with a flag are counted and looked for.
  SearchedLayers flag_layers = SearchedLayers::all;
};

// The group of layers that is chosen; -1: none.
inline int chosen_group(const LevelView& view, const Level& level) {
  const auto at = static_cast<std::size_t>(view.group.group);
  const bool is_there = view.group.group >= 0 && at < level.layers.groups.size() &&
                        level.layers.groups[at].name == view.group.name;
  return is_there ? view.group.group : -1;
}

}  // namespace talus
