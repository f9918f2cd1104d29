// Says why a tool paints nothing: the tools stay inside the selection.
#pragma once

#include "session/session.h"

namespace talus {

// Whether cells have one that may be painted; if not, a message tells why.
bool meets_selection(const Session& session, Actions& actions, CellRect cells);

}  // namespace talus
