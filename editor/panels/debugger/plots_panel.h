// Plots: expressions, with their current values and as curves over the whole branch.
#pragma once

#include <string>
#include <vector>

#include "expression_field.h"
#include "panels/panel.h"
#include "session/debugger/plot_list.h"

namespace talus {

class PlotsPanel final : public Panel {
 public:
  std::string_view id() const override { return panel_id::kPlots; }
  std::string_view title() const override { return "Plots"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_add(const Session& session, Actions& actions, Ui& ui);
  void draw_rows(const Session& session, Actions& actions, Ui& ui);
  void draw_row(std::size_t index, const Session& session, Actions& actions, Ui& ui);
  void draw_text(std::size_t index, const Session& session, Actions& actions, Ui& ui);
  void draw_times(const Session& session, Actions& actions, Ui& ui);
  void draw_curve(const std::string& name, const Series* series, ImU32 color, ImVec2 at,
                  const Session& session, Actions& actions, Ui& ui);

  std::string new_text_;
  ExpressionField new_field_;
  struct Row {
    std::string text;   // as it is being typed
    std::string shown;  // of the plot at the last look
    ExpressionField field;
  };
  std::vector<Row> rows_;
};

}  // namespace talus
