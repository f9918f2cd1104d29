// What the window of exports shows, besides what the session knows.
#pragma once

#include <cstddef>

namespace talus {

struct ExportView {
  bool open = false;
  std::size_t preset = 0;  // index of the one that is shown; of none: the last one
};

}  // namespace talus
