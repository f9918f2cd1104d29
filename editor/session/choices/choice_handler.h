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

  // --- What follows from other actions
  void choose_body(int id) { choices_.body = id; }  // 0: none
  void show_overlay(OverlayId overlay, bool on) { choices_.overlays.set(overlay, on); }
  void choose_sprite_tool(SpriteTool tool) { choices_.sprite_tool = tool; }
  // As an edit has it; to be cut when that is done.
  void choose_cells(const std::optional<CellRect>& cells) { choices_.selection = cells; }
  PixelSelection& pixels() { return choices_.pixels; }
  void cut_selection();  // at the edges of a map that may have become smaller
  void forget_level();   // another one is open

 private:
  // For each action of ChoiceAction: in choice_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  const OpenLevel& open_;
  Choices choices_;
};

}  // namespace talus
