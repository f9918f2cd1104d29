// Says why a tool paints nothing: tools stay inside of the selection.
#pragma once

#include "session/session.h"

namespace talus {

// Whether any of the cells may be painted; if not, a message says why.
bool meets_selection(const Session& session, Actions& actions, CellRect cells);

}  // namespace talus
