// ChoiceHandler: what the user has chosen.
#pragma once

#include "choices.h"
#include "session/editing/open_level.h"

namespace talus {

class ChoiceHandler {
 public:
  explicit ChoiceHandler(const OpenLevel& open) : open_(open) {}

  void apply(const ChoiceAction& action);
  const Choices& choices() const { return choices_; }

  // --- Results of other actions
  void choose_body(int id) { choices_.body = id; }  // 0: no body
  void show_overlay(const Overlay& overlay, bool on) { choices_.overlays.set(overlay, on); }
  void choose_sprite_tool(SpriteTool tool) { choices_.sprite_tool = tool; }
  // The selection that an edit has; cut it when the edit is done.
  void choose_cells(const std::optional<CellRect>& cells) { choices_.selection = cells; }
  PixelSelection& pixels() { return choices_.pixels; }
  void fit_level();     // cuts what is chosen at the edges of map and sheets, which may have become smaller
  void forget_level();  // another level is open
  // The first tile that can be seen, to paint with; tile 0 if there is none.
  void choose_first_tile();

 private:
  // For each action of ChoiceAction, in choice_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void fit_stamp(Stamp& stamp) const;

  const OpenLevel& open_;
  Choices choices_;
};

}  // namespace talus
