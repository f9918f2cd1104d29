// The window that finds tiles on the map and replaces them.
#pragma once

#include <string>

#include "panels/panel.h"

namespace talus {

class FindTilesPanel : public Panel {
 public:
  std::string_view id() const override { return "find_tiles"; }
  std::string_view title() const override { return "Find and replace tiles"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // The content of a tile's field: the tile, unless the user has typed a number that no tile has.
  struct Field {
    int typed = -1, tile = -1;
    bool is_tile() const { return typed == tile; }
  };
  void draw_tile(const std::string& name, const char* label, Field& field, int& tile, const Session& session,
                 Ui& ui) const;
  void draw_count(std::size_t count, bool of_selection, Ui& ui) const;

  Field find_, replace_;
};

}  // namespace talus
