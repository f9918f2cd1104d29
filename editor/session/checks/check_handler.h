// CheckHandler: likely problems of the level, where a player gets to, and proofs.
#pragma once

#include <optional>
#include <vector>

#include "check_actions.h"
#include "level/edit.h"
#include "level/lint/lint_cache.h"
#include "prover.h"
#include "reach_finder.h"
#include "session/choices/choice_handler.h"
#include "session/messages/message_handler.h"
#include "session/run/run_handler.h"

namespace talus {

class CheckHandler {
 public:
  CheckHandler(const OpenLevel& open, RunHandler& run, ChoiceHandler& choices, MessageHandler& messages)
      : open_(open), run_(run), choices_(choices), messages_(messages) {}

  void apply(const CheckAction& action);

  const std::vector<Problem>& problems();  // of the current level
  const Level& linted();                   // the level, or its ground_level() if that is another one
  const LintCache& lint_cache() const { return lint_cache_; }
  const LintOptions& lint_options() const { return lint_options_; }
  const ReachFinder& reach() const { return reach_; }
  const Prover& prover() const { return prover_; }

  void note_edit(const Edit& edit);                    // call it for each edit done or undone
  void forget_level();                                 // another level is open
  void note_other_layer() { lint_cache_.note_map(); }  // another layer of the map is chosen
  void follow_scene();                                 // results for another scene are out of date
  // Spends a few ms on the unchecked part of the level, and on where the player gets to. Takes a proof.
  void advance();

 private:
  // For each action of CheckAction, in check_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  bool is_compiled();  // brings the scene up to date; if that takes longer, tells so and returns false
  void lint_some();
  void note_ground(const Edit& edit);

  const OpenLevel& open_;
  RunHandler& run_;
  ChoiceHandler& choices_;
  MessageHandler& messages_;
  LintCache lint_cache_;
  std::optional<Level> ground_;    // ground_level() of the level; nothing: not needed, or out of date
  GroundNames ground_names_;       // of its tiles
  std::vector<Cell> noted_cells_;  // which `ground_` does not have yet
  LintOptions lint_options_;
  ReachFinder reach_;
  Prover prover_;
  int scene_ = 0;  // number of RunHandler::scenes() that reach_ and prover_ have noted
};

}  // namespace talus
