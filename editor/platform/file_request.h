// Which files the dialog asks for: what it says, what it lists, and what is done with the answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct FileRequest {
  // names, names_folder: where something will be written later; saves: it is written at once.
  enum class Purpose { opens, saves, names, names_folder };
  FileDialog dialog = FileDialog::open;
  Purpose purpose = Purpose::opens;
  std::string title;  // "Open a level or cart"
  std::string near;   // path: where to start and, unless it opens, the name to suggest; may be empty
  std::vector<std::string> endings;  // of the files that are listed: "tic", without the dot
  std::string ending;                // unless it opens: put behind a name without one

  bool names_new() const { return purpose != Purpose::opens; }
  bool names_folder() const { return purpose == Purpose::names_folder; }
};

// What the dialog that is open asks for; nothing: none is open.
std::optional<FileRequest> wanted_file(const Session& session, const View& view);
// What is done with the file that was chosen.
Action answer_to(FileDialog dialog, const std::string& path, const Session& session, const View& view);

}  // namespace talus
