// Searches a flag: the tiles that have it, and their cells on the map.
#pragma once

#include "level/flag_search.h"
#include "panels/panel.h"

namespace talus {

class FlagSearchPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kFlagSearch; }
  std::string_view title() const override { return "Find flags"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_choice(const Session& session, Actions& actions, Ui& ui);
  void count(const Session& session, FlagPattern pattern);
  void draw_tiles(const Session& session, Actions& actions, Ui& ui) const;

  FlagUse use_;  // of the pattern in the level of this revision
  std::optional<FlagPattern> counted_;
  std::uint64_t revision_ = 0;
};

}  // namespace talus
