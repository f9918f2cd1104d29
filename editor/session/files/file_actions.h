// Actions: opening and saving. What would lose unsaved changes is asked about first: see Session::question().
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <talus/formats/format.h>
#include <talus/level/level.h>
#include "sim/timeline.h"

namespace talus {
namespace action {

struct NewLevel {};
// A level, or a recording with its level; a PNG without a cart in it as OpenPng. Where there is something to
// choose of it first: see Session::level_import(). What takes long is read beside the editor: see
// Session::reading().
struct OpenFile {
  std::string path;
  bool as_copy = false;  // without a path, so that saving asks for one: for levels that come with the program
};
struct CancelReading {};  // of what Session::reading() tells; the level stays as it is
struct SetLevelImport {
  ImportChoices choices;
};
struct ApplyLevelImport {};  // while it cannot be read so, nothing happens
struct CancelLevelImport {};
struct SaveFile {};  // to its own path and format; without a name: see Session::wants_save_as()
struct SaveFileAs {
  std::string path;  // the format by its extension; with an unknown one nothing is saved
};
struct CancelSaveAs {};
struct SaveRecording {  // of the current branch; not while it is run again
  std::string path;
};
// A level that was saved by itself before the program was killed: its file is opened, if it has one, and the
// level comes as a change of it that can be undone. Asks as OpenFile does.
struct RecoverLevel {
  std::shared_ptr<const Level> level;  // never null
  std::string path;                    // empty: none
  std::string name;                    // for titles, without a path
  // Of the runs that were saved with it, none null; the last one is shown.
  std::vector<std::shared_ptr<const Recording>> recordings = {};
};
// Looks whether another program has changed the level's file; see Session::question().
struct CheckFile {};
struct Quit {};

}  // namespace action

// What FileHandler carries out.
using FileAction = std::variant<action::NewLevel, action::OpenFile, action::CancelReading,
                                action::SetLevelImport, action::ApplyLevelImport, action::CancelLevelImport,
                                action::SaveFile, action::SaveFileAs, action::CancelSaveAs,
                                action::SaveRecording, action::RecoverLevel, action::CheckFile, action::Quit>;

}  // namespace talus
