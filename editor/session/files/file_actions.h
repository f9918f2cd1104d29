// Actions: opening and saving. Actions that would lose unsaved changes ask first: see Session::question().
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <talus/formats/format.h>
#include <talus/level/level.h>
#include "edit/new_level.h"
#include "sim/timeline.h"

namespace talus {
namespace action {

struct NewLevel {
  TileSize tile = {};          // px
  int width = kTicMapWidth;    // cells
  int height = kTicMapHeight;  // cells; is_terrain_size must allow them (asserted)
  NewContent content = {};
};
struct OpenTiles {  // a PNG of tiles: see Session::tile_import()
  std::string path;
  bool adds = false;  // to the open level, as a tileset; else it becomes a new level
};
struct ApplyTiles {  // does nothing while there is no such picture, or it cannot be cut so
  TileCut cut = {};
  int width = 60;          // cells, of a new level's map
  int height = 34;         // cells, the same
  bool is_linked = false;  // whether the level shows the file instead of a copy
};
struct CancelTiles {};
// Opens a level, or a recording with its level; a PNG without a cart as OpenPng, or as OpenTiles if it is too
// large for the sheet or the sheet is in true colour. If the file leaves a choice:
// see Session::level_import(). Large files are read beside the editor: see Session::reading().
struct OpenFile {
  std::string path;      // of a folder: as OpenMaps
  bool as_copy = false;  // without a path, so that saving asks for one: for levels that come with the program
};
// Lists these files and the maps in these folders, and opens the first: see Session::maps().
struct OpenMaps {
  std::vector<std::string> paths;
};
// Opens the map that follows in the list; without one, in the folder of the file that was opened last.
struct OpenNextMap {
  int step = 1;  // -1: the one before
};
struct CancelReading {};  // of what Session::reading() shows; the level stays as it is
struct SetLevelImport {
  ImportChoices choices;
};
struct ApplyLevelImport {};  // does nothing while the file cannot be read with the choices
struct CancelLevelImport {};
// Opens the dialog again in which things of the level's project of LDtk are mapped; nothing for other levels.
struct AskLdtkMapping {};
struct SaveFile {};  // to its own path and format; without a name: see Session::wants_save_as()
struct SaveFileAs {
  std::string path;  // its extension gives the format; with an unknown one nothing is saved
};
struct CancelSaveAs {};
struct SaveRecording {  // of the current branch; not while it is run again
  std::string path;
};
// Recovers a level that was saved automatically before the program was killed: opens its file, if it has one,
// and makes the level an edit of it that can be undone. What another program has changed in the file since is
// kept, if `base` tells it. Asks as OpenFile does.
struct RecoverLevel {
  std::shared_ptr<const Level> level;  // never null
  std::string path;                    // empty: it has none
  std::string name;                    // for titles, without a path
  // The branches that were saved with it, never null; the last one is shown.
  std::vector<std::shared_ptr<const Recording>> recordings = {};
  std::shared_ptr<const Level> base = {};  // the level as its file had it then; null: unknown
  ImportChoices choices = {};              // how that was read
};
// Checks whether another program has changed the level's file; see Session::question().
struct CheckFile {};
struct Quit {};

}  // namespace action

// The actions that FileHandler carries out.
using FileAction =
    std::variant<action::NewLevel, action::OpenTiles, action::ApplyTiles, action::CancelTiles,
                 action::OpenFile, action::OpenMaps, action::OpenNextMap, action::CancelReading,
                 action::SetLevelImport, action::ApplyLevelImport, action::CancelLevelImport,
                 action::AskLdtkMapping, action::SaveFile, action::SaveFileAs, action::CancelSaveAs,
                 action::SaveRecording, action::RecoverLevel, action::CheckFile, action::Quit>;

}  // namespace talus
