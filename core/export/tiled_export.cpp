// Maps of Tiled in JSON and in XML, with the rest of the level in a property.
#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include <talus/level/placed_picture.h>
#include "../formats/native/native.h"
#include "../formats/pictures/png_sheet.h"
#include "../formats/text/append_number.h"
#include "../formats/text/json_text.h"
#include "../formats/text/xml_text.h"
#include "../formats/tiled/tiled_cells.h"
#include "../formats/tiled/tiled_xml.h"
#include "../level/layer_tree.h"
#include "export_targets.h"
#include "tiled_model.h"

namespace talus {
namespace {

constexpr double kModelShare = 0.4;  // share of the time; writing the text takes the rest

// JSON text with escapes for characters that XML does not have, so that names read back as they were.
std::string escaped_for_xml(std::string json) {
  for (const auto& [character, escape] :
       {std::pair{"\xef\xbf\xbe", "\\ufffe"}, {"\xef\xbf\xbf", "\\uffff"}}) {
    for (auto at = json.find(character); at != json.npos; at = json.find(character, at))
      json.replace(at, 3, escape);
  }
  return json;
}

// The level as a native one without the parts that the map has, in one line. JSON has its line breaks between
// members.
// objects: those of the level, as the map has them.
FormatResult<std::string> rest_of(const Level& level, std::vector<ObjectLayer> objects) {
  Level rest = level;
  rest.objects = std::move(objects);
  rest = without_groups(std::move(rest));
  const SheetLayout layout = rest.sheet(SheetId::tiles).layout();
  rest.sheet(SheetId::tiles) = {};
  rest.set_tile_layout(layout);
  rest.layers = {};
  rest.map = TileMap(level.map.width(), level.map.height(), level.map.tile_size());
  auto written = write_native(rest, {});
  if (!written) return tl::unexpected(written.error());
  std::string line;
  bool begins_line = false;
  for (const char c : written->bytes) {
    begins_line = c == '\n' || (begins_line && c == ' ');
    if (!begins_line) line += c;
  }
  return escaped_for_xml(std::move(line));
}

FormatResult<TiledExport> whole_map_of(const ExportRequest& request) {
  TiledExport made = tiled_export_of(request);
  auto rest = rest_of(request.level, std::move(made.objects));
  if (!rest) return tl::unexpected(rest.error());
  made.map.properties.push_back({std::string(kTiledLevelProperty), *std::move(rest)});
  return made;
}

Exported files_of(const ExportRequest& request, TiledExport made, std::string text) {
  return tiled_files(request, std::move(text), std::move(made.pictures), write_map_tiles(request.level),
                     std::move(made.dropped));
}

std::string number_word(double number) {
  std::string word;
  append_number(word, number);
  return word;
}

class TiledXmlWriter {
 public:
  std::string write(const TiledMap& map) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    put(declaration, "version", "1.0");
    put(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("map");
    put(root, "version", kTiledFormat);
    put(root, "tiledversion", kTiledVersion);
    put(root, "orientation", "orthogonal");
    put(root, "renderorder", std::string(word_of(map.order)));
    put(root, "width", map.width);
    put(root, "height", map.height);
    put(root, "tilewidth", map.tile_size.width);
    put(root, "tileheight", map.tile_size.height);
    put(root, "infinite", 0);
    if (!map.background.empty()) put(root, "backgroundcolor", map.background);
    pugi::xml_attribute next_layer = root.append_attribute("nextlayerid");
    pugi::xml_attribute next_object = root.append_attribute("nextobjectid");
    properties(root, map.properties);
    for (const TiledTileset& set : map.tilesets) tileset(root, set);
    for (const TiledLayer& one : map.layers) {
      pugi::xml_node parent = in_groups(root, map.groups, one.looks.group);
      layer(parent, one, map);
    }
    next_layer = next_layer_;
    next_object = next_object_;
    std::ostringstream out;
    document.save(out, " ", pugi::format_default, pugi::encoding_utf8);
    return out.str();
  }
  // What of the written map XML has no characters for, as Exported::dropped.
  std::vector<std::string> dropped() const {
    if (changed_texts_ == 0) return {};
    return {"control characters, which XML does not have, in " + std::to_string(changed_texts_) +
            (changed_texts_ == 1 ? " text" : " texts")};
  }

 private:
  static void put(pugi::xml_node& node, const char* name, const char* value) {
    node.append_attribute(name) = value;
  }
  void put(pugi::xml_node& node, const char* name, const std::string& value) {
    const std::string text = xml_text(value);
    if (text != value) ++changed_texts_;
    node.append_attribute(name) = text.c_str();
  }
  template <class Number>
  void put(pugi::xml_node& node, const char* name, Number value) {
    put(node, name, number_word(static_cast<double>(value)));
  }

  void animation(pugi::xml_node node, const std::vector<TiledTile::Frame>& frames) {
    for (const TiledTile::Frame& frame : frames) {
      pugi::xml_node entry = node.append_child("frame");
      put(entry, "tileid", frame.id);
      put(entry, "duration", frame.duration);
    }
  }

  void properties(pugi::xml_node& node, const TiledProperties& properties) {
    if (properties.empty()) return;
    pugi::xml_node list = node.append_child("properties");
    for (const TiledProperty& property : properties) {
      pugi::xml_node entry = list.append_child("property");
      put(entry, "name", property.name);
      if (const auto* truth = std::get_if<bool>(&property.value)) {
        put(entry, "type", "bool");
        put(entry, "value", *truth ? "true" : "false");
      } else if (const auto* whole = std::get_if<std::int64_t>(&property.value)) {
        put(entry, "type", "int");
        put(entry, "value", std::to_string(*whole));
      } else if (const auto* number = std::get_if<double>(&property.value)) {
        put(entry, "type", "float");
        put(entry, "value", *number);
      } else {
        put(entry, "value", std::get<std::string>(property.value));
      }
    }
  }

  void image(pugi::xml_node& node, const std::string& source, TileSize size) {
    pugi::xml_node image = node.append_child("image");
    put(image, "source", source);
    put(image, "width", size.width);
    put(image, "height", size.height);
  }

  void tileset(pugi::xml_node& root, const TiledTileset& set) {
    pugi::xml_node node = root.append_child("tileset");
    put(node, "firstgid", set.first_gid);
    put(node, "name", set.name);
    put(node, "tilewidth", set.tile_size.width);
    put(node, "tileheight", set.tile_size.height);
    put(node, "tilecount", set.tile_count);
    put(node, "columns", set.columns);
    if (!set.is_collection) image(node, set.image, {set.image_width, set.image_height});
    for (const TiledTile& one : *set.tiles) {
      pugi::xml_node tile = node.append_child("tile");
      put(tile, "id", one.id);
      if (!one.type.empty()) put(tile, "type", one.type);
      if (one.probability != 1) put(tile, "probability", one.probability);
      properties(tile, one.properties);
      if (set.is_collection) image(tile, one.image, one.image_size);
      if (!one.objects.empty()) {
        pugi::xml_node group = tile.append_child("objectgroup");
        put(group, "draworder", "index");
        int id = 0;  // counts within each tile
        objects(group, one.objects, id);
      }
      if (!one.animation.empty()) animation(tile.append_child("animation"), one.animation);
    }
  }

  // The element of a group, in those around it. They are the last ones if their layers came last.
  pugi::xml_node in_groups(pugi::xml_node parent, const LayerGroups& groups, int group) {
    const std::vector<int> around = groups_around(groups, group);
    std::size_t same = 0;
    while (same < open_.size() && same < around.size() && open_[same].first == around[same]) ++same;
    open_.resize(same);
    if (same > 0) parent = open_.back().second;
    for (std::size_t i = same; i < around.size(); ++i) {
      const LayerGroup& its = groups[static_cast<std::size_t>(around[i])];
      parent = parent.append_child("group");
      put(parent, "id", next_layer_++);
      put(parent, "name", its.name);
      if (!its.visible) put(parent, "visible", 0);
      looks(parent, its);
      open_.emplace_back(around[i], parent);
    }
    return parent;
  }

  void layer(pugi::xml_node& root, const TiledLayer& layer, const TiledMap& map) {
    const char* const kind = layer.has_tiles ? "layer" : layer.image ? "imagelayer" : "objectgroup";
    pugi::xml_node node = root.append_child(kind);
    put(node, "id", next_layer_++);
    put(node, "name", layer.name);
    if (layer.is_hidden || !layer.looks.visible) put(node, "visible", 0);
    if (!layer.has_tiles) return other_layer(node, layer);
    put(node, "width", map.width);
    put(node, "height", map.height);
    looks(node, layer.looks);
    properties(node, tiled_properties(layer.looks));
    pugi::xml_node data = node.append_child("data");
    if (layer.cells.size() > kMaxListedCells) {
      put(data, "encoding", "base64");
      put(data, "compression", "zlib");
      data.append_child(pugi::node_pcdata).set_value(encode_tiled_cells(layer.cells).c_str());
      return;
    }
    put(data, "encoding", "csv");
    std::string csv = "\n";
    for (std::size_t i = 0; i < layer.cells.size(); ++i) {
      append_number(csv, layer.cells[i]);
      if (i + 1 < layer.cells.size()) csv += ',';
      if ((i + 1) % static_cast<std::size_t>(map.width) == 0) csv += '\n';
    }
    data.append_child(pugi::node_pcdata).set_value(csv.c_str());
  }

  // Of objects, or a picture.
  void other_layer(pugi::xml_node& node, const TiledLayer& layer) {
    looks(node, layer.looks);
    if (layer.image) {
      if (layer.image->repeats_x) put(node, "repeatx", 1);
      if (layer.image->repeats_y) put(node, "repeaty", 1);
      if (layer.image->path.empty()) return;
      pugi::xml_node picture = node.append_child("image");
      put(picture, "source", layer.image->path);
      return;
    }
    int id = next_object_ - 1;
    put(node, "draworder", layer.by_y ? "topdown" : "index");
    properties(node, layer.properties);
    objects(node, layer.objects, id);
    next_object_ = id + 1;
  }

  // Those that are not the usual ones.
  template <class Layer>
  void looks(pugi::xml_node& node, const Layer& looks) {
    if (looks.locked) put(node, "locked", 1);
    if (looks.opacity != 1) put(node, "opacity", looks.opacity);
    if (looks.offset.x != 0) put(node, "offsetx", looks.offset.x);
    if (looks.offset.y != 0) put(node, "offsety", looks.offset.y);
    if (looks.parallax.x != 1) put(node, "parallaxx", looks.parallax.x);
    if (looks.parallax.y != 1) put(node, "parallaxy", looks.parallax.y);
    if (looks.tint != Rgb{255, 255, 255}) put(node, "tintcolor", tiled_color(looks.tint));
  }

  void objects(pugi::xml_node& group, const std::vector<TiledObject>& objects, int& id) {
    for (const TiledObject& object : objects) {
      pugi::xml_node node = group.append_child("object");
      put(node, "id", ++id);
      if (!object.name.empty()) put(node, "name", object.name);
      if (!object.type.empty()) put(node, "type", object.type);
      if (object.gid != 0) put(node, "gid", object.gid);
      put(node, "x", object.position.x);
      put(node, "y", object.position.y);
      if (object.size != Vec2{0, 0}) {
        put(node, "width", object.size.x);
        put(node, "height", object.size.y);
      }
      if (object.rotation != 0) put(node, "rotation", object.rotation);
      if (!object.visible) put(node, "visible", 0);
      properties(node, object.properties);
      if (object.form == TiledObject::Form::ellipse) node.append_child("ellipse");
      if (is_point(object)) node.append_child("point");
      if (object.points.empty()) continue;
      std::string points;
      for (const Vec2 p : object.points) {
        if (!points.empty()) points += ' ';
        points += number_word(p.x) + ',' + number_word(p.y);
      }
      pugi::xml_node line =
          node.append_child(object.form == TiledObject::Form::polygon ? "polygon" : "polyline");
      put(line, "points", points);
    }
  }

  int next_layer_ = 1, next_object_ = 1;
  std::vector<std::pair<int, pugi::xml_node>> open_;  // the groups of the last layer, with their elements
  int changed_texts_ = 0;                             // by xml_text()
};

}  // namespace

FormatResult<Exported> export_tmj(const ExportRequest& request) {
  auto made = whole_map_of(request);
  if (!made) return tl::unexpected(made.error());
  if (!request.progress.at(kModelShare)) return Exported();
  std::string text = tiled_json_text(made->map);
  if (auto problem = problem_of_size(text)) return tl::unexpected(FormatError{"", *std::move(problem)});
  return files_of(request, *std::move(made), std::move(text));
}

FormatResult<Exported> export_tmx(const ExportRequest& request) {
  auto made = whole_map_of(request);
  if (!made) return tl::unexpected(made.error());
  if (!request.progress.at(kModelShare)) return Exported();
  TiledXmlWriter writer;
  std::string text = writer.write(made->map);
  if (auto problem = problem_of_tiled_xml(text)) return tl::unexpected(FormatError{"", *std::move(problem)});
  for (std::string& phrase : writer.dropped()) made->dropped.push_back(std::move(phrase));
  return files_of(request, *std::move(made), std::move(text));
}

}  // namespace talus
