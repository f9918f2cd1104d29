// Reads projects and levels of LDtk from their JSON.
#pragma once

#include <talus/formats/format.h>
#include "ldtk_project.h"

namespace talus {

// The definitions, and what is said of each level. The project refers to `json`. An error is anything that
// cannot be part of a project.
FormatResult<LdtkProject> read_ldtk_project(const Json& json);

// A level with its layers. json: the level's object, of the project or of its own file. path: of that object
// in its file.
FormatResult<LdtkLevel> read_ldtk_level(const LdtkProject& project, const LdtkLevelHead& head,
                                        const Json& json, const std::string& path);

}  // namespace talus
