// Exports the level in one click, without a preset made before.
#pragma once

#include "export/exporter.h"
#include "session/session.h"

namespace talus {

// Exports by the level's first preset with that target, or by a new one, which the level keeps. A message
// says where it was written, or why there is no room for another preset.
void export_as(const Exporter& exporter, const Session& session, Actions& actions);

}  // namespace talus
