// Writes exports on a command line, where nobody can be asked: files of the user's own are not replaced.
#pragma once

#include "command.h"
#include "export/export_plan.h"

namespace talus {

struct ExportRules {
  bool fresh = false;  // starters are written anew even if the user has changed them
  bool force = false;  // files beside the named one, or in the folder, are replaced whoever wrote them
  bool allow_outside = false;  // files may leave their folder: see ExportBounds
};

struct ExportOrder {
  const Level& level;
  std::string input;     // the level's file, for errors about its content
  std::string exporter;  // id
  std::string output;    // file or folder; - for standard output
  std::string parts = {};
  std::string preset = {};   // name, for an error about its target
  bool is_of_level = false;  // whether the level, and not the user, says where it is written
  ExportRules rules = {};
  bool tells = false;  // reports what was written, and creates the folder of a single file, too
};

// Writes the export, and reports on the error stream what was kept, what could not be held, and what went
// wrong. A file that the user did not name is replaced only if it is an unchanged export, by the record in
// the state folder. No file is written through a link that leaves the folder. If the record does not know the
// files, as after a move to another place, an earlier export counts if all of it is there.
void carry_out(CommandContext& context, const ExportOrder& order);

}  // namespace talus
