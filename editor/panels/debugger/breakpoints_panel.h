// Breakpoints: what stops the game, forwards and backwards.
#pragma once

#include <array>
#include <map>

#include "debug/breakpoint.h"
#include "expression_field.h"
#include "panels/panel.h"

namespace talus {

class BreakpointsPanel final : public Panel {
 public:
  std::string_view id() const override { return panel_id::kBreakpoints; }
  std::string_view title() const override { return "Breakpoints"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_run(const Session& session, Actions& actions, Ui& ui);
  void draw_add(const Session& session, Actions& actions, Ui& ui);
  void draw_fields(const BreakpointKindInfo& info, const Session& session, Actions& actions, Ui& ui);
  void fill_in_place(const Session& session, Ui& ui);
  void put_place(CellRect cells, const TileMap& map);
  void draw_list(const Session& session, Actions& actions, Ui& ui);
  void draw_row(const Breakpoint& breakpoint, const Session& session, Actions& actions, Ui& ui);

  BreakpointKind kind_ = BreakpointKind::touches_tile;  // kind of the next breakpoint
  std::array<double, 4> fields_{};                      // its numbers
  bool fields_set_ = false;
  bool fields_typed_ = false;  // typed by the user, or picked: they no longer follow what is clicked
  ExpressionField new_field_;
  std::map<int, std::string> texts_;  // by id: texts as they are being typed
  std::map<int, ExpressionField> condition_fields_;
};

}  // namespace talus
