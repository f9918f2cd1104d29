// Actions: stopping a run, watching its numbers and comparing it with another one.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "debug/stop_search.h"
#include "session/debugger/watches.h"
#include "session/run/variant_run.h"

namespace talus {
namespace action {

struct SetBreakpoint {  // in the place of the one with its id; id 0: a new one
  Breakpoint breakpoint;
};
struct RemoveBreakpoint {
  int breakpoint = 0;  // id
};
// Pauses, and shows the next frame at which a breakpoint stops, or the one before. Where nothing recorded
// stops, forwards goes on playing.
struct RunToStop {
  SearchDirection direction = SearchDirection::forwards;
};
struct FindParting {     // shows the first frame in which a body is apart from the same one on the other side
  double threshold = 0;  // px, finite and >= 0: by more than this
};
struct SetParting {      // how far bodies are from their other selves when the sides have parted
  double threshold = 0;  // px; a negative one gives 0, what is no number changes nothing
};
struct CancelSearch {};
struct SetWatch {  // in the place of the one with this index; a larger one: a new one
  std::size_t index = 0;
  WatchText watch;
};
struct RemoveWatch {
  std::size_t index = 0;
};
struct CompareVariant {            // runs the same input through it, beside what is shown
  std::optional<Variant> variant;  // nothing: no longer
};

}  // namespace action

// What DebugHandler carries out.
using DebugAction = std::variant<action::SetBreakpoint, action::RemoveBreakpoint, action::RunToStop,
                                 action::FindParting, action::SetParting, action::CancelSearch,
                                 action::SetWatch, action::RemoveWatch, action::CompareVariant>;

}  // namespace talus
