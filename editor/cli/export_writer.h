// Writing exports on a command line, where nobody can be asked: what is somebody's own is not replaced.
#pragma once

#include "command.h"
#include "export/export_plan.h"

namespace talus {

struct ExportRules {
  bool fresh = false;  // starters are written anew where the user has other ones
  bool force = false;  // files beside the named one, or in the folder, are replaced whoever wrote them
  bool allow_outside = false;  // files may leave the folder that they belong to: see ExportBounds
};

struct ExportOrder {
  const Level& level;
  std::string input;     // file that the level is from, for errors of its content
  std::string exporter;  // id
  std::string output;    // file or folder; - for standard output
  std::string parts = {};
  std::string preset = {};   // name, for an error about its target
  bool is_of_level = false;  // the level says where it is written, and not the user
  ExportRules rules = {};
  bool tells = false;  // a line of what was written, and makes the folder of a single file, too
};

// Carries it out, and says on the error stream what was kept, what could not be held, and what went wrong. A
// file that the user did not name is replaced only if it is as an export wrote it, which the record in the
// state folder tells, and none is written through a link that leaves the folder. Of files that it knows
// nothing about, as after a move to another place, an earlier export is told by being there as a whole.
void carry_out(CommandContext& context, const ExportOrder& order);

}  // namespace talus
