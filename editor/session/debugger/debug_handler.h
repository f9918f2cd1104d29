// DebugHandler: lets the debugger stop the run, and tells what it found.
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

  // Brings the debugger up to the run; to be called whenever that has changed.
  void follow() { debugger_.follow(run_.timeline(), open_.level); }
  void forget_run() { debugger_.forget_run(); }  // the run is of another level now
  void play(double seconds);                     // until a breakpoint stops it
  void advance();                                // goes on with what the debugger has to do

 private:
  // For each action of DebugAction: in debug_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void note_stop();  // it has stopped at debugger_.stop()

  const OpenLevel& open_;
  RunHandler& run_;
  ChoiceHandler& choices_;
  MessageHandler& messages_;
  Debugger debugger_;
  bool plays_on_ = false;      // when the search that is under way finds nothing
  std::string nothing_found_;  // what is said then, unless it plays on
};

}  // namespace talus
