// What Talus adds to a level of LDtk, as JSON, and the two together again.
//
//   "members"  of a native level (see native.h), what differs from that of LDtk; null removes a member
//   "map"      [width, height], if it has another size
//   "background"  members of the layer of the picture behind the level that differ; null: it was removed
//   "layers"   from the back, if they are others or look otherwise: "ldtk", by which the layer is known in
//              the project, with its members that differ; or "new", a layer that LDtk does not have, and its
//              cells as "runs" of what was empty; "known", the layers that LDtk had
//   "cells"    painted cells, by "ldtk" of their layer: "runs" of [x, y, tiles, the tiles before]
//   "spawns", "curves"  "added", [place in the list, entry]; "gone", entries of LDtk
//   "sheet"    [columns, tiles] of the sheet of tiles; it gives the digits of the cells of brushes
//   "picture"  by tile the pixels in true colour, lines of Base64 with a zlib stream; null: there is none
#pragma once

#include <talus/formats/format.h>
#include "../text/json_text.h"

namespace talus {

// held: the level that LDtk alone gives.
FormatResult<Json> ldtk_additions(const Level& level, const Level& held);

struct LdtkConflicts {
  int cells = 0;    // painted ones that LDtk has changed, too: they are as in LDtk
  int entries = 0;  // bodies that were changed here and in LDtk: both are there
  int layers = 0;   // with painted cells, that LDtk no longer has
  bool any() const { return cells + entries + layers > 0; }
};
// Adds them to what LDtk gives now. The result has no origin.
FormatResult<Level> add_to_ldtk(const Json& additions, const Level& held, LdtkConflicts& conflicts);

}  // namespace talus
