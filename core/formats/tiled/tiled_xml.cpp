// Attributes become members; elements become what Tiled's JSON has for them. Their names do not mix: elements
// make a fixed set of names, which no attribute and no other element may have. pugixml reads no other files,
// entities or document types, and needs no stack for deep nesting.
#include "tiled_xml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <utility>

#include <talus/level/limits.h>
#include "../files/atomic_file.h"
#include "../text/utf8_text.h"
#include "../text/xml_text.h"
#include "tiled_map.h"
#include "tiled_node.h"

namespace talus {
namespace {

constexpr int kMaxGroups = 32;  // nested layers; well below kMaxJsonDepth
constexpr std::size_t kMaxXmlParts =
    2'500'000;  // elements and attributes; CSV needs none for 4096x4096 cells
// JSON values that are made of them. Maps that Talus writes need hardly more than they have parts.
constexpr std::size_t kMaxXmlValues = 2'600'000;

constexpr std::array<std::string_view, 27> kXmlNumbers = {
    "width",      "height",    "x",        "y",       "id",          "firstgid", "tilewidth",
    "tileheight", "tilecount", "columns",  "spacing", "margin",      "rotation", "gid",
    "tileid",     "duration",  "infinite", "visible", "opacity",     "offsetx",  "offsety",
    "parallaxx",  "parallaxy", "repeatx",  "repeaty", "probability", "locked"};

// Members that elements make. Attributes cannot have these names, so lists are always lists.
constexpr std::array<std::string_view, 16> kElementMembers = {
    "layers",  "tilesets",    "tiles",       "objects",         "properties", "objectgroup",
    "data",    "imagewidth",  "imageheight", "chunks",          "animation",  "encoding",
    "polygon", "compression", "polyline",    "transparentcolor"};
// Elements that become a member of their name; only their presence counts.
constexpr std::array<std::string_view, 11> kMarkElements = {
    "image", "ellipse",  "point",        "text",           "capsule",        "tileoffset",
    "grid",  "wangsets", "terraintypes", "editorsettings", "transformations"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Finds text with characters that XML does not have, which references such as "&#xD800;" may bring.
class BadText : public pugi::xml_tree_walker {
 public:
  pugi::xml_node where;  // null: there is none

  bool for_each(pugi::xml_node& node) override {
    bool good = is_xml_text(node.value());
    for (const pugi::xml_attribute attribute : node.attributes())
      good = good && is_xml_text(attribute.value());
    if (!good) where = node;
    return good;
  }
};

std::size_t count_objects(std::string_view xml) {
  constexpr std::string_view kTag = "<object";
  std::size_t count = 0;
  for (std::size_t at = xml.find(kTag); at != xml.npos; at = xml.find(kTag, at + 1))
    count += xml.substr(at + kTag.size(), 1) != "g" ? 1 : 0;  // an objectgroup is not an object
  return count;
}

// Those in the manner in which Talus writes them.
std::size_t count_points(std::string_view xml) {
  constexpr std::string_view kPoints = " points=\"";
  std::size_t count = 0;
  for (std::size_t at = xml.find(kPoints); at != xml.npos; at = xml.find(kPoints, at)) {
    at += kPoints.size();
    const std::string_view points = xml.substr(at, xml.find('"', at) - at);
    count += 1 + static_cast<std::size_t>(std::count(points.begin(), points.end(), ' '));
  }
  return count;
}

// A number that JSON can hold; other text stays text, which the reader reports.
Json number_or_text(std::string_view text) {
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = problem == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return is_number ? json_number(number) : Json(text);
}

Json property_value(const pugi::xml_node& property) {
  const std::string_view type = property.attribute("type").value();
  const pugi::xml_attribute value = property.attribute("value");
  const std::string_view text = value ? value.value() : property.child_value();  // of several lines
  if (type == "bool") return text == "true";
  if (type == "int" || type == "float") return number_or_text(text);
  return text;
}

std::string_view layer_type(std::string_view element) {
  if (element == "layer") return "tilelayer";
  const bool is_layer = element == "objectgroup" || element == "imagelayer" || element == "group";
  return is_layer ? element : "";
}

// Thrown and caught in this file only.
struct XmlStopped {};

class TiledXml {
 public:
  TiledXml(std::string_view text, const Progress& progress) : text_(text), progress_(progress) {}

  FormatResult<Json> read() {
    try {
      return read_document();
    } catch (const XmlStopped&) {
      if (error_) return tl::unexpected(*error_);
      return was_cancelled();
    }
  }

 private:
  FormatResult<Json> read_document() {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text_.data(), text_.size(),
                                             pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
    if (!parsed)
      return error_at_line(text_, static_cast<std::size_t>(parsed.offset), "this is not valid XML");
    if (!document.document_element()) return error_at_line(text_, text_.size() - 1, "this is not valid XML");
    for (const pugi::xml_node node : document.children()) {
      if (node == document.document_element()) continue;
      const std::size_t begin =
          text_.find_first_not_of(" \t\r\n", static_cast<std::size_t>(node.offset_debug()));
      return error_at_line(text_, begin, "there is more than one element in the XML");
    }
    BadText bad;
    document.traverse(bad);
    if (bad.where) fail(bad.where, "refers to a character that does not exist");
    const pugi::xml_node root = document.document_element();
    const std::string_view name = root.name();
    const bool is_known = name == "map" || name == "tileset" || name == "template";
    if (!error_ && !is_known) return tl::unexpected(FormatError{"", "is not a Tiled map or tileset"});
    Json json;
    if (!error_) json = name == "map" ? map(root) : name == "tileset" ? tileset(root) : object_template(root);
    if (error_) return tl::unexpected(*error_);
    json["type"] = name;
    return json;
  }

  // The attributes, with the line. Elements come in the order of the file, so lines are counted once.
  Json attributes(const pugi::xml_node& node) {
    Json json = Json::object();
    count_values(node, 2);
    json[kXmlLineKey] = line_of(node);
    for (const pugi::xml_attribute attribute : node.attributes()) {
      count_values(node, 1);
      std::string name = attribute.name();
      const bool is_number = is_one_of(kXmlNumbers, name);
      if (is_one_of(kElementMembers, name) || is_one_of(kMarkElements, name))
        name += "=";  // nothing has such a name
      put_once(node, name, is_number ? number_or_text(attribute.value()) : Json(attribute.value()), json);
    }
    return json;
  }

  std::int64_t line_of(const pugi::xml_node& node) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    if (offset >= counted_ && offset <= text_.size()) {
      lines_ += std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                           text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
      counted_ = offset;
    }
    if (!progress_.at(counted_, text_.size())) throw XmlStopped();
    return lines_;
  }

  Json map(const pugi::xml_node& node) {
    Json json = attributes(node);
    json["layers"] = json["tilesets"] = Json::array();
    for (const pugi::xml_node child : node.children()) add_to_map(child, 0, json);
    return json;
  }

  void add_to_map(const pugi::xml_node& child, int groups, Json& json) {
    const std::string_view name = child.name();
    if (name == "tileset" && groups == 0) {
      if (++tilesets_ > kMaxTiledTilesets) stop(child, tiled_too_many("tileset", kMaxTiledTilesets));
      json["tilesets"].push_back(tileset(child));
    } else if (!layer_type(name).empty()) {
      if (++layers_ > kMaxTiledLayers) stop(child, tiled_too_many("layer", kMaxTiledLayers));
      json["layers"].push_back(layer(child, groups));
    } else {
      add_common(child, json);
    }
  }

  // For elements that nobody reads the name is enough: the reader reports it.
  void add_common(const pugi::xml_node& child, Json& json) {
    const std::string name = child.name();
    if (name == "properties")
      put_once(child, name, properties(child), json);
    else if (child.type() == pugi::node_element)
      json[is_one_of(kMarkElements, name) ? name : "<" + name + ">"] = true;
  }

  Json properties(const pugi::xml_node& node) {
    Json list = Json::array();
    for (const pugi::xml_node child : node.children("property")) {
      count_values(child, 4);
      Json json = {{"name", child.attribute("name").value()}, {"value", property_value(child)}};
      json[kXmlLineKey] = line_of(child);
      if (child.child("properties")) json.erase("value");  // a value with members
      list.push_back(std::move(json));
    }
    return list;
  }

  Json tileset(const pugi::xml_node& node) {
    Json json = attributes(node);
    count_values(node, 1);
    json["tiles"] = Json::array();
    for (const pugi::xml_node child : node.children()) {
      const std::string_view name = child.name();
      if (name == "image") {
        add_image(child, json);
      } else if (name == "tileoffset") {
        put_once(child, "tileoffset", attributes(child), json);
      } else if (name == "tile") {
        json["tiles"].push_back(tile(child));
      } else {
        add_common(child, json);
      }
    }
    return json;
  }

  void add_image(const pugi::xml_node& node, Json& json) {
    const pugi::xml_node data = node.child("data");
    const bool is_inside = std::string_view(data.attribute("encoding").value()) == "base64";
    std::string name = node.attribute("source").value();
    if (is_inside)
      name = "data:image/" + std::string(node.attribute("format").value()).substr(0, 8) + ";base64," +
             data.text().get();
    put_once(node, "image", std::move(name), json);
    for (const char* side : {"width", "height"}) {
      if (const auto length = node.attribute(side))
        json[std::string("image") + side] = number_or_text(length.value());
    }
    if (node.attribute("trans")) json["transparentcolor"] = node.attribute("trans").value();
  }

  Json tile(const pugi::xml_node& node) {
    Json json = attributes(node);
    for (const pugi::xml_node child : node.children()) {
      if (std::string_view(child.name()) == "objectgroup")
        put_once(child, "objectgroup", layer(child, 1), json);
      else if (std::string_view(child.name()) == "image")
        add_image(child, json);
      else if (std::string_view(child.name()) == "animation")
        put_once(child, "animation", frames(child), json);
      else
        add_common(child, json);
    }
    return json;
  }

  Json frames(const pugi::xml_node& animation) {
    Json list = Json::array();
    for (const pugi::xml_node frame : animation.children("frame")) list.push_back(attributes(frame));
    return list;
  }

  Json layer(const pugi::xml_node& node, int groups) {
    Json json = attributes(node);
    count_values(node, 3);
    json["type"] = layer_type(node.name());
    json["layers"] = json["objects"] = Json::array();
    if (groups > kMaxGroups) {
      fail(node, "is nested too deep in groups");
      return json;
    }
    for (const pugi::xml_node child : node.children()) {
      const std::string_view name = child.name();
      if (name == "data")
        add_data(child, json);
      else if (name == "image")
        add_image(child, json);
      else if (name == "object")
        json["objects"].push_back(object(child));
      else
        add_to_map(child, groups + 1, json);
    }
    return json;
  }

  void add_data(const pugi::xml_node& node, Json& json) {
    line_of(node);
    for (const char* key : {"encoding", "compression"}) {
      if (node.attribute(key)) json[key] = node.attribute(key).value();
    }
    if (!node.child("chunk")) return put_once(node, "data", cells(node, node), json);
    Json chunks = Json::array();
    for (const pugi::xml_node chunk : node.children("chunk")) {
      chunks.push_back(attributes(chunk));
      chunks.back()["data"] = cells(chunk, node);
    }
    put_once(node, "chunks", std::move(chunks), json);
  }

  // data: the element that has the encoding.
  static Json cells(const pugi::xml_node& node, const pugi::xml_node& data) {
    if (data.attribute("encoding")) return node.child_value();
    Json cells = Json::array();
    for (const pugi::xml_node cell : node.children("tile")) {
      const pugi::xml_attribute gid = cell.attribute("gid");
      cells.push_back(gid ? number_or_text(gid.value()) : Json(0));
    }
    return cells;
  }

  Json object(const pugi::xml_node& node) {
    Json json = attributes(node);
    for (const pugi::xml_node child : node.children()) {
      const std::string_view name = child.name();
      if (name == "polygon" || name == "polyline")
        put_once(child, child.name(), child.attribute("points").value(), json);
      else
        add_common(child, json);
    }
    return json;
  }

  Json object_template(const pugi::xml_node& node) {
    Json json = Json::object();
    if (const auto set = node.child("tileset")) json["tileset"] = tileset(set);
    if (const auto content = node.child("object")) json["object"] = object(content);
    return json;
  }

  // An element that is there twice is an error, as in JSON. node: the one whose line the error names.
  void put_once(const pugi::xml_node& node, const std::string& name, Json value, Json& json) {
    if (json.contains(name)) return fail(node, "has \"" + name + "\" twice");
    json[name] = std::move(value);
  }

  void fail(const pugi::xml_node& node, std::string message) {
    if (!error_) error_ = FormatError{"line " + std::to_string(line_of(node)), std::move(message)};
  }

  [[noreturn]] void stop(const pugi::xml_node& node, std::string message) {
    fail(node, std::move(message));
    throw XmlStopped();
  }

  // node: the element of which so many values are about to be made.
  void count_values(const pugi::xml_node& node, std::size_t count) {
    if (values_ += count; values_ > kMaxXmlValues) stop(node, "is one element too many");
  }

  std::string_view text_;
  std::size_t layers_ = 0, tilesets_ = 0, values_ = 0;  // made so far
  std::size_t counted_ = 0;                             // bytes of the text in which lines have been counted
  std::int64_t lines_ = 1;
  std::optional<FormatError> error_;
  const Progress& progress_;
};

}  // namespace

std::optional<std::string> problem_of_tiled_xml(std::string_view text) {
  if (text.size() > kMaxTmxBytes)
    return "takes " + std::to_string(text.size() >> 20) + " MiB as a file, but Talus reads only up to " +
           std::to_string(kMaxTmxBytes >> 20);
  const auto parts = std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; });
  if (static_cast<std::size_t>(parts) > kMaxXmlParts) return "has too many elements";
  if (const std::size_t objects = count_objects(text); objects > kMaxTiledObjects) {
    return "has " + std::to_string(objects) + " objects, but a map may have at most " +
           std::to_string(kMaxTiledObjects);
  }
  if (const std::size_t points = count_points(text); points > kMaxTiledPoints) {
    return "has " + std::to_string(points) + " points, but a map may have at most " +
           std::to_string(kMaxTiledPoints);
  }
  return std::nullopt;
}

FormatResult<Json> tiled_json_of_xml(std::string_view text, const Progress& progress) {
  if (auto problem = problem_of_tiled_xml(text)) return tl::unexpected(FormatError{"", *std::move(problem)});
  if (!is_utf8(text)) return tl::unexpected(FormatError{"", "is not UTF-8 text"});
  return TiledXml(text, progress).read();
}

}  // namespace talus
