// The lower part of the window of exports: the files that a preset would write, what is lost, and the
// progress of writing.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// "812 bytes", "44.2 KB", "1.3 MB"
std::string size_text(std::size_t bytes);

// Of the shown preset, as the preview knows it; null where there is none, or it is of another preset.
const ExportOutcome* shown_outcome(const Session& session, const Ui& ui);

// The problem of one of the shown preset's fields, in the colour of errors; false when there is none.
bool draw_export_problem(ExportProblem::Field field, const Session& session, Ui& ui);
// The files in a list that leaves `below` px.
void draw_export_files(const Session& session, float below, Ui& ui);
// What is not held, and how large the code is. Height: two lines of text.
void draw_export_notes(const Session& session, Ui& ui);
// The button that exports, or what an export is at with the button that ends it.
void draw_export_buttons(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
