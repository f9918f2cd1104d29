// OpenCopies: copies of the level in the formats of other programs that have them open, updated whenever the
// level is saved.
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
    std::vector<std::string> dropped;  // as in Exported
    std::string kept;  // new name of the file that another program had saved there; empty: there was none
    std::string record_problem = {};  // of ExportRecord::save(); empty: no problem
  };

  // folder: of the copies; created when needed.
  explicit OpenCopies(std::string folder) : folder_(std::move(folder)) {}

  // Writes the level now, and again whenever it is saved to its file. program: must have a format of its own.
  // The error names the copy.
  tl::expected<Written, std::string> write(const Session& session, const ProgramInfo& program);

  // Call it after each frame's actions: writes the copies again when the level has been saved, and reports
  // it. A copy that the other program has changed stays as it is and is no longer updated.
  void follow(Session& session);
  void forget() { copies_.clear(); }  // when another level is opened

 private:
  struct Copy {
    ProgramId program;
    Written written;
    std::optional<FileStamp> stamp;  // of the file as it was written
  };
  // What this program has written there, also in earlier starts. Read when it is needed, not at the start.
  ExportRecord record() const { return ExportRecord(folder_ + "/written"); }
  tl::expected<std::string, std::string> make_room(const std::vector<std::string>& files) const;
  std::string note(const std::vector<std::string>& files) const;  // the problem of the record
  std::string write_again(const Session& session, Copy& copy) const;

  std::string folder_;
  std::string level_file_;  // of the level that the copies belong to; empty: it had no file yet
  std::vector<Copy> copies_;
  int saves_ = 0;  // of the session at the last look
};

}  // namespace talus
