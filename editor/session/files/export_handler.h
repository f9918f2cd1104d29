// ExportHandler: exports of the level's presets, with their questions and messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <talus/collision/function_ref.h>
#include "export_actions.h"
#include "exporting.h"
#include "session/editing/level_handler.h"

namespace talus {

class ExportHandler {
 public:
  ExportHandler(OpenLevel& open, LevelHandler& level, MessageHandler& messages, ExportTools tools)
      : open_(open), level_(level), messages_(messages), exporting_(std::move(tools)) {}

  void apply(const ExportAction& action);
  const Exporting& exporting() const { return exporting_; }
  ExportTask task(std::size_t preset) const;  // index of one of the level's presets
  // The run that the question is about, if it is about exports; else null.
  const FinishedRun* asked() const { return asked_run_ ? &*asked_run_ : nullptr; }

  void export_on_save();
  void forget_level();  // another level is open
  void take_exports();  // takes the results of the thread

 private:
  // For each action of ExportAction, in export_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void export_presets(FunctionRef<bool(std::size_t)> is_wanted, bool on_save);
  void go_on_with_file();
  void tell_of(const FinishedRun& finished);
  void ask_to_allow(FinishedRun finished);
  void answer_to_allow(bool allowed);
  void ask_to_replace(FinishedRun finished);

  OpenLevel& open_;
  LevelHandler& level_;
  MessageHandler& messages_;
  std::string not_remembered_;  // why permissions could not be saved, until it is reported; empty: they could
  std::vector<ExportPreset> declined_;    // not allowed when a save asked, which does not ask again
  std::optional<FinishedRun> asked_run_;  // waits for the question's answer
  std::optional<action::RunExports> waits_for_file_;  // until the user has given the level one, or has not
  Exporting exporting_;
};

}  // namespace talus
