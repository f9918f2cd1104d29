// Searches a flag: the tiles that have it, and their cells on the map.
#pragma once

#include "level/flag_search.h"
#include "panels/panel.h"

namespace talus {

class FlagSearchPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kFlagSearch; }
  std::string_view title() const override { return "Find"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_choice(const Session& session, Actions& actions, Ui& ui);
  void draw_layer_choice(const Session& session, Ui& ui);
  void count(const Session& session, FlagPattern pattern, SearchedLayers layers);
  void draw_tiles(const Session& session, Actions& actions, Ui& ui) const;

  FlagUse use_;  // of the pattern in these layers of the level of this revision
  std::optional<FlagPattern> counted_;
  SearchedLayers layers_ = SearchedLayers::all;
  int layer_ = 0;  // the chosen one
  std::uint64_t revision_ = 0;
};

}  // namespace talus
