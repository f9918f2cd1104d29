// OpenCopies: the level in the formats of programs of others that have it open there, kept up to what is
// saved.
#pragma once

#include <string>
#include <vector>

#include "export/exporter.h"
#include "panels/window/programs.h"
#include "session/files/export_record.h"
#include "session/files/file_stamp.h"
#include "session/session.h"

namespace talus {

class OpenCopies {
 public:
  struct Written {
    std::string path;
    std::vector<std::string> dropped;  // as Exported has it
    std::string kept;                 // where what another program had saved there is now; empty: nothing had
    std::string record_problem = {};  // of ExportRecord::save(); empty: none
  };

  // folder: of the copies; made when it is needed.
  explicit OpenCopies(std::string folder) : folder_(std::move(folder)) {}

  // Writes the level as it is, and from then on whenever it is saved to its file. program: with a format of
  // its own. The error names the copy.
  tl::expected<Written, std::string> write(const Session& session, const ProgramInfo& program);

  // To be called after each frame's actions: writes the copies again when the level has been saved, and tells
  // so. What the other program has changed in its copy stays, and the copy is given up.
  void follow(Session& session);
  void forget() { copies_.clear(); }  // another level is opened

 private:
  struct Copy {
    ProgramId program;
    Written written;
    std::optional<FileStamp> stamp;  // of the file as it was written
  };
  // What this program has written there, in earlier starts, too. Read when it is needed, not at the start.
  ExportRecord record() const { return ExportRecord(folder_ + "/written"); }
  tl::expected<std::string, std::string> make_room(const std::vector<std::string>& files) const;
  std::string note(const std::vector<std::string>& files) const;  // the problem of the record
  std::string write_again(const Session& session, Copy& copy) const;

  std::string folder_;
  std::string level_file_;  // of the level whose copies they are; empty: it had none yet
  std::vector<Copy> copies_;
  int saves_ = 0;  // of the session, when last looked at
};

}  // namespace talus
