// Projects of LDtk, `.ldtk`, with their levels in the project or in files of their own, `.ldtkl`. They are
// only read here; core/export writes them.
//
// Files of levels and pictures are found by relative paths from the folder of the project. Without a folder,
// levels in files of their own are an error, and pictures are left out.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

bool accepts_ldtk(std::string_view bytes, const FormatContext& context);

// A level of a project.
struct LdtkLevelName {
  std::string iid;            // empty: it has none
  std::string name;           // may be the same as that of others
  std::string world;          // the name of its world; empty: the project has no worlds
  int x = 0, y = 0;           // px, of its corner in the world; levels in a row without places all have -1
  int depth = 0;              // levels of a greater one lie above
  int width = 0, height = 0;  // px
  Rgb color;                  // of its background
};
// The levels of all worlds in their order, as ImportChoices::level_number counts them. Empty if the file is
// not a readable project, or if `progress` stopped the work.
std::vector<LdtkLevelName> ldtk_levels_of_file(const std::string& path, const Progress& progress = {});

// Reads the levels of all worlds in their order, and gives each that can be read to `use`, with its index.
// Which level the choices name does not count. Ends when `progress` stops the work.
void read_ldtk_levels(const std::string& path, const ImportChoices& choices,
                      const std::function<void(std::size_t, const Level&)>& use, const Progress& progress);

// Reads the level that the choices name. If a project has several, one must be chosen.
FormatResult<Level> read_ldtk(std::string_view bytes, const FormatContext& context);

}  // namespace talus
