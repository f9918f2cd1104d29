// FileRequest: which files the dialog asks for: its texts, its list, and what happens with the answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct FileRequest {
  // names, names_folder: something will be written there later; saves: it is written at once.
  enum class Purpose { opens, saves, names, names_folder };
  FileDialog dialog = FileDialog::open;
  Purpose purpose = Purpose::opens;
  std::string title;  // "Open a level or cart"
  std::string near;   // path: where to start and, unless it opens, the name to suggest; may be empty
  std::vector<std::string> endings;  // extensions of the listed files: "tic", without the dot
  std::string ending;                // unless it opens: the extension for a name without one

  bool names_new() const { return purpose != Purpose::opens; }
  bool names_folder() const { return purpose == Purpose::names_folder; }
};

// The dialog that should be open: for a file that the session needs, or else `asked`, the one that the user
// has opened. Nothing if none should be open.
std::optional<FileRequest> wanted_file(const Session& session, const View& view,
                                       std::optional<FileDialog> asked);
// Acts on the chosen file.
Action answer_to(FileDialog dialog, const std::string& path, const Session& session, const View& view);

}  // namespace talus
