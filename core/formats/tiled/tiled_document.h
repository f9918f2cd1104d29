// TiledDocument: the text of a map or a tileset of Tiled, which is changed at places of it and stays as it is
// everywhere else.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include "tiled_edits.h"

namespace talus {

// Cells of a tile layer that are stored together: all of them, or a part of an infinite map.
struct TiledBlock {
  int x = 0, y = 0, width = 0, height = 0;  // cells
  std::vector<std::uint32_t> cells;         // row by row, as in TiledLayer
  bool is_chunk = false;                    // whether it has a place of its own; always in infinite maps
};

class TiledDocument {
 public:
  virtual ~TiledDocument() = default;

  virtual bool is_map() const = 0;  // else it is a tileset
  virtual bool is_infinite() const = 0;
  // Of a map with as many tile layers; groups do not count. layer: from 0, in the order of the file.
  virtual int layer_count() const = 0;
  // The same of all other layers: of objects, and of pictures.
  virtual int object_layer_count() const = 0;
  // In the order of the file: of those that overlap, the last one counts. A layer of a finite map has one at
  // least, also if the file has no cells of it.
  virtual FormatResult<std::vector<TiledBlock>> blocks(int layer) const = 0;
  // Puts other cells into a block, by its place in blocks(). A block that is no chunk may get another size.
  virtual void put_cells(int layer, std::size_t block, const TiledBlock& content) = 0;
  // Call it once for a layer.
  virtual void add_chunks(int layer, const std::vector<TiledBlock>& chunks) = 0;
  // Sets what differs of a layer or a group: its name, whether it is shown, locked and ground, its opacity,
  // tint, offset and parallax.
  virtual void set_looks(TiledLayerKind kind, int layer, const TileLayer& before, const TileLayer& now) = 0;
  // Sets whether the objects of a layer are drawn in the order of their y; else as listed.
  virtual void set_draw_order(int layer, bool by_y) = 0;
  // Changes objects of a layer. New ones get numbers that no other object of the map has. Call it once for a
  // layer.
  virtual void edit_objects(int layer, const std::vector<TiledObjectEdit>& edits) = 0;
  // All layers and groups of a map, as they stand in it.
  virtual TiledLayerTree layer_tree() const = 0;
  // Gives the map these layers and groups; those that it lacks go. Moved ones keep their text. New layers of
  // tiles are empty, in the encoding of the first layer. Call nothing else for the same document.
  virtual void arrange(const TiledLayerTree& tree) = 0;
  // Sets the size of a layer of tiles, cells. Call it beside put_cells().
  virtual void set_layer_size(int layer, int width, int height) = 0;
  // Sets the colour of the background of the map, as TiledMap::background.
  virtual void set_background(const std::string& color) = 0;
  // Sets the size of the map and of its tile layers.
  virtual void set_size(int width, int height) = 0;

  // Changes tiles of a tileset whose text is in this one. tileset: from 0, in the order of the file; of a
  // tileset's own file 0. What has no place in the text is left out. Call it once for a tileset.
  virtual void edit_tiles(int tileset, const TiledTileEdits& edits) = 0;

  // With all changes, in UTF-8; without any, the bytes that were read.
  virtual std::string text() const = 0;
};

// Which of two values that Tiled mixes are to be written.
struct TintEdits {
  bool opacity = false, tint = false;
};
// tint: the colour in the file, whose alpha is a part of the layer's opacity.
TintEdits tint_edits(const TileLayer& before, const TileLayer& now, std::string_view tint);

// bytes: a file that read_tiled() has read. They must live as long as the document.
// text: the same in UTF-8; empty if the bytes are that.
FormatResult<std::unique_ptr<TiledDocument>> tiled_xml_document(std::string_view bytes,
                                                                std::string text = {});
FormatResult<std::unique_ptr<TiledDocument>> tiled_json_document(std::string_view bytes);
FormatResult<std::unique_ptr<TiledDocument>> tiled_document(std::string_view bytes);

// The last line break of a text.
std::string_view line_end_of(std::string_view text);

}  // namespace talus
