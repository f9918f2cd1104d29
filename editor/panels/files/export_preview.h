// The lower part of the export window: the files that a preset would write, what is lost, and the progress of
// writing.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// "812 bytes", "44.2 KB", "1.3 MB"
std::string size_text(std::size_t bytes);

// The preview of the shown preset; null if there is none, or it belongs to another preset.
const ExportOutcome* shown_outcome(const Session& session, const Ui& ui);

// The problem of one of the shown preset's fields, in the colour of errors. Returns false if there is none.
bool draw_export_problem(ExportProblem::Field field, const Session& session, Ui& ui);
// The files in a list that leaves `below` px.
void draw_export_files(const Session& session, float below, Ui& ui);
// What the target cannot hold, and the size of the code. Height: two lines of text.
void draw_export_notes(const Session& session, Ui& ui);
// The export button, or the progress of an export with the button that ends it.
void draw_export_buttons(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
