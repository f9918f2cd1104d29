// The shape that the shape editor shows and changes. Its panel, its canvas and its commands share it.
#pragma once

#include <optional>
#include <string>

#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct EditedShape {
  int tile = -1;         // the first selected one; -1 if sprites are selected, which have no shapes
  TileSize size;         // px, of a tile
  TileShape whole;       // of the tile; invalid if it is a draft
  std::size_t part = 0;  // of `whole`, the edited one
  std::optional<std::size_t> point;  // of the part, the chosen one
  bool is_draft = false;             // it is shown instead of the tile's shape, as it is invalid
  bool is_drawing = false;           // the points of a further polygon are being set

  // The edited part; nothing for a tile without a shape.
  const TileShape& shape() const { return part_count(whole) > 0 ? part_at(whole, part) : whole; }
  bool is_polygon() const { return shape().kind == TileShape::Kind::polygon; }
};

// Whether it has polygons, or will have, and so may go beyond the tile.
inline bool is_open(const EditedShape& edited) { return has_parts(edited.whole) || edited.is_drawing; }

// Of the first selected tile. What no longer fits to the level is left out.
EditedShape edited_shape(const Session& session, const View& view);

// Makes it the shape of the selected tiles, which must be tiles (see change_shapes()). An invalid shape
// becomes a draft instead, and the edits of the stroke are taken back. stroke: of the drag that it belongs
// to; 0: none.
void put_shape(const Session& session, Actions& actions, View& view, const TileShape& whole, int stroke = 0);
// The same with another shape of the edited part.
void put_part(const Session& session, Actions& actions, View& view, const TileShape& part, int stroke = 0);

// Lets the user set the points of a further polygon. The functions below need a selected tile, too.
void begin_drawing(const Session& session, View& view);
// Adds the drawn polygon to the shape, as a part of its own if there are others. With fewer than three points
// this says so instead.
void close_drawing(const Session& session, Actions& actions, View& view);
// Takes the last point of an unfinished polygon back; without points, ends it. Must be drawing (asserted).
void drop_last_point(View& view);
// Drops the draft, or takes back the last point of an unfinished polygon. Returns false if there is neither.
bool take_back_unfinished(const Session& session, View& view);
// Removes a point of the edited polygon; says so if it has no point too many.
void remove_point(const Session& session, Actions& actions, View& view, std::size_t point);
// Adds a part to the shape and chooses it.
void add_part(const Session& session, Actions& actions, View& view, TileShape::Kind kind);

// Why the shape is not in the level, as a sentence; empty if it is.
std::string draft_text(const EditedShape& edited);

}  // namespace talus
