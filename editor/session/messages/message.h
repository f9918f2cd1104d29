// The messages and questions of a session.
#pragma once

#include <string>

namespace talus {

struct Message {
  std::string text;
  bool is_error = false;
  bool offers_ground = false;  // with a button that makes the tiles of the chosen layer ground
  std::string place = {};      // path of what was exported, with a button that copies it; empty: none
};

// Something that would lose unsaved changes waits for an answer.
struct Question {
  enum class Kind {
    unsaved_changes,
    changed_outside,
    drop_branch,
    replace_files,
    unsaved_branch,
    unstored,
    allow_exports,
    merge,
    read_outside,
    paint_file,
    beyond_file
  };
  std::string text;  // "Save the changes to demo.talus.json?"
  Kind kind = Kind::unsaved_changes;
};

}  // namespace talus
