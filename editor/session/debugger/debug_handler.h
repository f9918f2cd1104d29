// DebugHandler: lets the debugger stop the game, and reports what it found.
#pragma once

#include <string>

#include "debug_actions.h"
#include "debugger.h"
#include "session/choices/choice_handler.h"
#include "session/messages/message_handler.h"
#include "session/run/run_handler.h"

namespace talus {

class DebugHandler {
 public:
  DebugHandler(const OpenLevel& open, RunHandler& run, ChoiceHandler& choices, MessageHandler& messages)
      : open_(open), run_(run), choices_(choices), messages_(messages) {}

  void apply(const DebugAction& action);
  const Debugger& debugger() const { return debugger_; }

  // Brings the debugger up to the timeline; call it whenever that has changed.
  void follow() { debugger_.follow(run_.timeline(), open_.level); }
  void forget_timeline() { debugger_.forget_timeline(); }  // it belongs to another level now
  void play(double seconds);                               // until a breakpoint stops it
  void advance();                                          // continues the debugger's work

 private:
  // For each action of DebugAction, in debug_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  // Pauses. plays_on, nothing_found: as the members.
  void prepare_search(bool plays_on, std::string nothing_found);
  void note_stop();  // the game has stopped at debugger_.stop()

  const OpenLevel& open_;
  RunHandler& run_;
  ChoiceHandler& choices_;
  MessageHandler& messages_;
  Debugger debugger_;
  bool plays_on_ = false;      // whether it plays on if the current search finds nothing
  std::string nothing_found_;  // the message in that case, unless it plays on
};

}  // namespace talus
