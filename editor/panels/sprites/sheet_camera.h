// SheetCamera: which part of the sheet its panel shows. It zooms and moves as the canvases of the level do.
#pragma once

#include "level/cell_rect.h"
#include "panels/canvas/camera_hand.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// The shown tiles on the screen.
struct SheetView {
  CanvasView canvas;  // in px of the art, from the first shown tile on; the cell is a tile
  CellRect tiles;     // the shown columns and rows of the sheet

  float cell() const { return canvas.zoom * static_cast<float>(canvas.tile.width); }  // px of the screen
  // Where tile 0 of the whole sheet is, or would be; px of the screen.
  ImVec2 first() const { return canvas.corner_of({-tiles.x, -tiles.y}); }
  ImVec2 min() const { return canvas.corner_of({0, 0}); }
  ImVec2 max() const { return canvas.corner_of({tiles.w, tiles.h}); }
  // A place on the sheet, which may be beside the shown tiles.
  Cell place_at(ImVec2 mouse) const {
    const Cell cell = canvas.to_cell(mouse);
    return {cell.x + tiles.x, cell.y + tiles.y};
  }
};

class SheetCamera {
 public:
  // Call it first in each frame, with the shown columns and rows and the panel's room, px of the screen.
  // Another level, sheet or tileset is shown from its corner, at a zoom of the user's if there is one.
  void begin(const Session& session, Ui& ui, CellRect tiles, ImVec2 room);
  SheetView view(ImVec2 corner) const { return {camera_.view(corner, room_, tile_), tiles_}; }
  // For ImGui's last item, at `corner`, which is the panel's room. Returns whether the mouse moves the view.
  bool take_mouse(const Session& session, const Ui& ui, ImVec2 corner);
  // Shows these columns and rows of the sheet, unless they are in sight.
  void show(CellRect tiles);
  // Shows a place, in px of the art.
  void show(Vec2 place);

 private:
  // What is shown; the view starts afresh when it changes.
  struct Subject {
    int level_number = -1;
    SheetId sheet = SheetId::tiles;
    int tileset = -1;
    friend bool operator==(const Subject&, const Subject&) = default;
  };
  Vec2 size() const {
    return {1.0 * tiles_.w * tile_.width, 1.0 * tiles_.h * tile_.height};
  }  // px of the art
  void start_afresh(const Ui& ui);

  Camera camera_;
  CameraHand hand_;
  bool zoom_is_chosen_ = false;  // by the user, who keeps it for other levels and tilesets
  Subject subject_;
  CellRect tiles_;
  TileSize tile_;  // px of the art; tiles are drawn as squares
  ImVec2 room_;
};

}  // namespace talus
