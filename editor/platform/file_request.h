// Which files the dialog asks for: what it says, what it lists, and what is done with the answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct FileRequest {
  FileDialog dialog = FileDialog::open;
  bool saves = false;
  std::string title;  // "Open a level or cart"
  std::string near;   // path: where to start and, for saving, the name to suggest; may be empty
  std::vector<std::string> endings;  // of the files that are listed: "tic", without the dot
  std::string ending;                // for saving: put behind a name without one
};

// What the dialog that is open asks for; nothing: none is open.
std::optional<FileRequest> wanted_file(const Session& session, const View& view);
// What is done with the file that was chosen.
Action answer_to(FileDialog dialog, const std::string& path);

}  // namespace talus
