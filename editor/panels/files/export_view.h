// What the export window shows, besides what the session knows.
#pragma once

#include <cstddef>

namespace talus {

struct ExportView {
  bool open = false;
  std::size_t preset = 0;  // index of the shown preset; beyond the list: the last one
};

}  // namespace talus
