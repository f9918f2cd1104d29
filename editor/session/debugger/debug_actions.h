// Actions: stopping the game, plotting the numbers of a branch and comparing it with another one.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "debug/breakpoint_search.h"
#include "session/debugger/plot_list.h"
#include "session/run/variant_branch.h"

namespace talus {
namespace action {

struct SetBreakpoint {  // replaces the one with its id; id 0: a new one
  Breakpoint breakpoint;
};
struct RemoveBreakpoint {
  int breakpoint = 0;  // id
};
// Pauses, and shows the next or the previous frame at which a breakpoint stops. If no recorded frame stops,
// forwards goes on playing.
struct RunToBreakpoint {
  SearchDirection direction = SearchDirection::forwards;
};
struct FindLastStop {  // pauses, and shows the last frame before this one in which a body was stopped
  int body = 0;        // id; 0 finds nothing
};
struct FindParting {     // shows the first frame in which a body is apart from the same one on the other side
  double threshold = 0;  // px, finite and >= 0: the distance must be larger
};
struct SetParting {      // sets the distance of bodies from which on the sides count as parted
  double threshold = 0;  // px; a negative one gives 0, NaN or infinity changes nothing
};
struct CancelSearch {};
struct SetPlot {  // replaces the one with this index; a larger index: a new one
  std::size_t index = 0;
  PlotText plot;
};
struct RemovePlot {
  std::size_t index = 0;
};
struct CompareVariant {            // runs the same input through it, beside the shown branch
  std::optional<Variant> variant;  // nothing: ends the comparison
};

}  // namespace action

// The actions that DebugHandler carries out.
using DebugAction =
    std::variant<action::SetBreakpoint, action::RemoveBreakpoint, action::RunToBreakpoint,
                 action::FindLastStop, action::FindParting, action::SetParting, action::CancelSearch,
                 action::SetPlot, action::RemovePlot, action::CompareVariant>;

}  // namespace talus
