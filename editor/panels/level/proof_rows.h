// The proof of the level, as rows below the list of problems.
#pragma once

#include <talus/collision/function_ref.h>
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// How many findings the proof has, listed or not; 0: there is no proof.
std::size_t findings_of(const Session& session);

// px of the screen, of the widest place of a row.
float width_of_places(const Session& session);

// Shows and plays the finding after the one that was gone to last, or the first.
void go_to_next_finding(const Session& session, Actions& actions, Ui& ui);

// Draws the button that begins or ends a proof.
void draw_proof_button(const Session& session, Actions& actions, Ui& ui);

// Draws the button that fixes what was found in a cell, if there is a fix. index: of the row.
using DrawFix = FunctionRef<void(Cell cell, std::size_t index)>;

// Draws what was proved, and a row for each finding. A click on one shows its place and plays it. Call it
// within a table with the columns place, message and button. is_wide: places have a line of their own, above
// the message.
void draw_proof_rows(bool is_wide, const Session& session, Actions& actions, Ui& ui, DrawFix draw_fix);

}  // namespace talus
