// The window that finds tiles on the map and replaces them.
#pragma once

#include "panel.h"

namespace talus {

class FindTilesPanel : public Panel {
 public:
  std::string_view id() const override { return "find_tiles"; }
  std::string_view title() const override { return "Find and replace tiles"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
