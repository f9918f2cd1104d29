// Gathers what changes among the children of an element, and writes it at once.
#include "tiled_xml_editor.h"

#include <algorithm>
#include <array>

#include "../text/append_number.h"

namespace talus {
namespace {

constexpr std::array<const char*, 6> kObjectForms = {"polygon", "polyline", "ellipse",
                                                     "point",   "text",     "capsule"};

std::vector<pugi::xml_node> elements_in(const pugi::xml_node& parent) {
  std::vector<pugi::xml_node> elements;
  for (const pugi::xml_node child : parent.children()) {
    if (child.type() == pugi::node_element) elements.push_back(child);
  }
  return elements;
}

pugi::xml_node element_after(pugi::xml_node node) {
  do node = node.next_sibling();
  while (node && node.type() != pugi::node_element);
  return node;
}

std::string text_of_number(double number) {
  std::string text;
  append_number(text, number == 0 ? 0 : number);  // without the sign of -0
  return text;
}

std::string attribute_text(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_attribute_text(value) + "\"";
}

std::string text_of_points(const std::vector<Vec2>& points) {
  std::string text;
  for (const Vec2 point : points)
    text += (text.empty() ? "" : " ") + text_of_number(point.x) + "," + text_of_number(point.y);
  return text;
}

struct ValueText {
  std::string type, text;
};
struct ValueWriter {
  ValueText operator()(bool value) const { return {"bool", value ? "true" : "false"}; }
  ValueText operator()(std::int64_t value) const { return {"int", std::to_string(value)}; }
  ValueText operator()(double value) const { return {"float", text_of_number(value)}; }
  ValueText operator()(const std::string& value) const { return {"", value}; }
};

const char* form_of(const TiledObject& object) {
  switch (object.form) {
    case TiledObject::Form::polygon:
      return "polygon";
    case TiledObject::Form::polyline:
      return "polyline";
    case TiledObject::Form::ellipse:
      return "ellipse";
    default:
      return "";
  }
}
bool has_points(const TiledObject& object) {
  return object.form == TiledObject::Form::polygon || object.form == TiledObject::Form::polyline;
}

bool is_blank_text(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// Whether the edits take all that is in the group.
bool leave_nothing(const pugi::xml_node& group, const std::vector<TiledObjectEdit>& edits) {
  const bool all_remove = std::all_of(edits.begin(), edits.end(), [](const auto& e) { return e.removes; });
  return all_remove && !edits.empty() && edits.size() == elements_in(group).size();
}

// Whether a property of this type in the file can hold such a value.
bool takes_value(std::string_view type, const ValueText& value) {
  if (value.type.empty()) return type.empty() || type == "string" || type == "color" || type == "file";
  if (value.type == "int") return type == "int" || type == "object" || type == "float";
  return type == value.type;
}

int next_id_in(const pugi::xml_node& group) {
  int last = 0;
  for (const pugi::xml_node object : group.children("object"))
    last = std::max(last, object.attribute("id").as_int());
  return last + 1;
}

}  // namespace

TiledXmlEditor::TiledXmlEditor(std::string_view text, const XmlPlaces& places, const pugi::xml_node& root,
                               TextEdits& edits)
    : text_(text), places_(places), root_(root), edits_(edits) {
  const std::vector<pugi::xml_node> elements = elements_in(root);
  if (elements.empty()) return;
  const std::string line = places.break_before(elements.front());
  const std::size_t begin = line.find_first_not_of("\r\n");
  if (begin != line.npos) unit_ = line.substr(begin);
}

bool TiledXmlEditor::Changes::removes(const pugi::xml_node& child) const {
  return std::find(removed.begin(), removed.end(), child) != removed.end();
}

void TiledXmlEditor::edit_tiles(const pugi::xml_node& tileset, const TiledTileEdits& edits) {
  std::vector<std::pair<int, pugi::xml_node>> tiles;
  for (const pugi::xml_node tile : tileset.children("tile"))
    tiles.emplace_back(tile.attribute("id").as_int(), tile);
  Changes changes;
  for (const auto& [id, edit] : edits) {
    const auto same =
        std::find_if(tiles.begin(), tiles.end(), [id = id](const auto& t) { return t.first == id; });
    if (same != tiles.end()) {
      if (edit_tile(same->second, edit)) changes.removed.push_back(same->second);
      continue;
    }
    const auto after =
        std::find_if(tiles.begin(), tiles.end(), [id = id](const auto& t) { return t.first > id; });
    pugi::xml_node next;
    if (after != tiles.end())
      next = after->second;
    else
      next = tiles.empty() ? tileset.child("wangsets") : element_after(tiles.back().second);
    NewElement tile = new_tile(id, edit);
    const bool has_type = edit.type && !edit.type->empty();
    if (!tile.children.empty() || edit.probability || has_type)
      changes.added.emplace_back(next, std::move(tile));
  }
  change_children(tileset, changes);
}

bool TiledXmlEditor::edit_tile(const pugi::xml_node& tile, const TiledTileEdit& edit) {
  Changes changes;
  if (edit.probability == 1.0)
    remove_xml_attribute(places_, tile, "probability", edits_);
  else if (edit.probability)
    set_xml_attribute(places_, tile, "probability", text_of_number(*edit.probability), edits_);
  if (edit.type && edit.type->empty())
    remove_xml_attribute(places_, tile, type_key(tile), edits_);
  else if (edit.type)
    set_xml_attribute(places_, tile, type_key(tile), *edit.type, edits_);
  const pugi::xml_node group = tile.child("objectgroup");
  if (group && !edit.objects.empty()) {
    int id = next_id_in(group);
    if (leave_nothing(group, edit.objects))
      changes.removed.push_back(group);
    else
      edit_objects(group, edit.objects, [&] { return id++; });
  }
  edit_properties(tile, edit.properties, changes);
  const NewElement fresh = new_tile(0, {edit.objects, {}});
  if (!group && !fresh.children.empty())
    changes.added.emplace_back(tile.child("animation"), fresh.children[0]);
  if (edit.animation) edit_animation(tile, *edit.animation, changes);
  const std::vector<pugi::xml_node> elements = elements_in(tile);
  const bool has_only_id = !edit.probability && !edit.type && tile.attribute("id") &&
                           tile.first_attribute() == tile.last_attribute();
  if (has_only_id && changes.added.empty() && !elements.empty() && changes.removed.size() == elements.size())
    return true;
  change_children(tile, changes);
  return false;
}

void TiledXmlEditor::edit_animation(const pugi::xml_node& tile, const std::vector<TiledTile::Frame>& frames,
                                    Changes& changes) {
  if (const pugi::xml_node old = tile.child("animation")) changes.removed.push_back(old);
  if (!frames.empty()) changes.added.emplace_back(pugi::xml_node(), new_animation(frames));
}

TiledXmlEditor::NewElement TiledXmlEditor::new_animation(const std::vector<TiledTile::Frame>& frames) {
  NewElement animation{"animation"};
  for (const auto& [id, duration] : frames)
    animation.children.push_back({"frame", attribute_text("tileid", std::to_string(id)) +
                                               attribute_text("duration", std::to_string(duration))});
  return animation;
}

TiledXmlEditor::NewElement TiledXmlEditor::new_tile(int id, const TiledTileEdit& edit) const {
  NewElement tile{"tile", attribute_text("id", std::to_string(id))};
  if (edit.type && !edit.type->empty()) tile.attributes += attribute_text(type_key({}), *edit.type);
  if (edit.probability) tile.attributes += attribute_text("probability", text_of_number(*edit.probability));
  if (NewElement list = new_properties(edit.properties); !list.children.empty())
    tile.children.push_back(std::move(list));
  NewElement group{"objectgroup", " draworder=\"index\""};
  int next_id = 1;
  for (const TiledObjectEdit& object : edit.objects) {
    if (object.index < 0) group.children.push_back(new_object(object, next_id++));
  }
  if (!group.children.empty()) tile.children.push_back(std::move(group));
  if (edit.animation && !edit.animation->empty()) tile.children.push_back(new_animation(*edit.animation));
  return tile;
}

void TiledXmlEditor::edit_objects(const pugi::xml_node& group, const std::vector<TiledObjectEdit>& edits,
                                  const std::function<int()>& next_id) {
  const auto range = group.children("object");
  const std::vector<pugi::xml_node> objects(range.begin(), range.end());
  Changes changes;
  for (const TiledObjectEdit& edit : edits) {
    if (edit.index < 0) {
      const bool is_last = edit.at < 0 || static_cast<std::size_t>(edit.at) >= objects.size();
      const pugi::xml_node before = is_last ? pugi::xml_node() : objects[static_cast<std::size_t>(edit.at)];
      changes.added.emplace_back(before, new_object(edit, next_id()));
    } else if (static_cast<std::size_t>(edit.index) < objects.size()) {
      const pugi::xml_node object = objects[static_cast<std::size_t>(edit.index)];
      if (edit.removes)
        changes.removed.push_back(object);
      else
        edit_object(object, edit);
    }
  }
  change_children(group, changes);
}

const char* TiledXmlEditor::type_key(const pugi::xml_node& object) const {
  if (object.attribute("class")) return "class";
  if (object.attribute("type")) return "type";
  const std::string_view version = root_.attribute("version").value();
  return version == "1.9" ? "class" : "type";
}

TiledXmlEditor::NewElement TiledXmlEditor::new_object(const TiledObjectEdit& edit, int id) const {
  const TiledObject& object = *edit.object;
  NewElement element{"object", attribute_text("id", std::to_string(id))};
  const auto add = [&](const char* name, const std::string& value) {
    element.attributes += attribute_text(name, value);
  };
  if (!object.name.empty()) add("name", object.name);
  if (!object.type.empty()) add(type_key({}), object.type);
  if (object.form == TiledObject::Form::tile) add("gid", std::to_string(object.gid));
  add("x", text_of_number(object.position.x));
  add("y", text_of_number(object.position.y));
  if (object.size.x != 0) add("width", text_of_number(object.size.x));
  if (object.size.y != 0) add("height", text_of_number(object.size.y));
  if (object.rotation != 0) add("rotation", text_of_number(object.rotation));
  if (NewElement list = new_properties(edit.properties); !list.children.empty())
    element.children.push_back(std::move(list));
  if (const std::string form = form_of(object); !form.empty()) {
    const std::string points =
        has_points(object) ? attribute_text("points", text_of_points(object.points)) : "";
    element.children.push_back({form, points});
  } else if (is_point(object)) {
    element.children.push_back({"point"});
  }
  return element;
}

void TiledXmlEditor::edit_object(const pugi::xml_node& object, const TiledObjectEdit& edit) {
  Changes changes;
  edit_properties(object, edit.properties, changes);
  if (edit.object && edit.before)
    edit_differences(object, *edit.before, *edit.object, changes);
  else if (edit.object)
    edit_all(object, *edit.object, changes);
  change_children(object, changes);
}

// What its template says needs a value of its own even where that is the usual one.
void TiledXmlEditor::edit_differences(const pugi::xml_node& object, const TiledObject& before,
                                      const TiledObject& now, Changes& changes) {
  const bool has_template = object.attribute("template");
  const auto set_text = [&](const char* name, const std::string& old, const std::string& value) {
    if (old == value) return;
    if (value.empty() && !has_template)
      remove_xml_attribute(places_, object, name, edits_);
    else
      set_xml_attribute(places_, object, name, value, edits_);
  };
  const auto set_number = [&](const char* name, double old, double value) {
    if (old == value) return;
    if (value == 0 && std::string_view(name).size() > 1 && !has_template)
      remove_xml_attribute(places_, object, name, edits_);
    else
      set_xml_attribute(places_, object, name, text_of_number(value), edits_);
  };
  set_text("name", before.name, now.name);
  set_text(type_key(object), before.type, now.type);
  if (now.gid != before.gid) set_xml_attribute(places_, object, "gid", std::to_string(now.gid), edits_);
  if (now.visible != before.visible)
    set_xml_attribute(places_, object, "visible", now.visible ? "1" : "0", edits_);
  set_number("x", before.position.x, now.position.x);
  set_number("y", before.position.y, now.position.y);
  set_number("width", before.size.x, now.size.x);
  set_number("height", before.size.y, now.size.y);
  set_number("rotation", before.rotation, now.rotation);
  if (now.form != before.form || now.points != before.points || is_point(now) != is_point(before))
    edit_form(object, now, changes);
}

void TiledXmlEditor::edit_all(const pugi::xml_node& object, const TiledObject& now, Changes& changes) {
  if (now.name != object.attribute("name").value())
    set_xml_attribute(places_, object, "name", now.name, edits_);
  const char* const key = type_key(object);
  if (now.type != object.attribute(key).value() && !now.type.empty())
    set_xml_attribute(places_, object, key, now.type, edits_);
  edit_number(object, "x", now.position.x);
  edit_number(object, "y", now.position.y);
  edit_number(object, "width", now.size.x);
  edit_number(object, "height", now.size.y);
  edit_number(object, "rotation", now.rotation);
  edit_form(object, now, changes);
}

void TiledXmlEditor::edit_form(const pugi::xml_node& object, const TiledObject& now, Changes& changes) {
  const std::string form = form_of(now);
  for (const char* other : kObjectForms) {
    const bool stays = form == other || (is_point(now) && std::string_view(other) == "point");
    if (const pugi::xml_node child = object.child(other); child && !stays) changes.removed.push_back(child);
  }
  if (form.empty()) return;
  const std::string points = has_points(now) ? text_of_points(now.points) : "";
  const pugi::xml_node known = object.child(form.c_str());
  if (known && has_points(now)) set_xml_attribute(places_, known, "points", points, edits_);
  if (known) return;
  changes.added.emplace_back(pugi::xml_node(),
                             NewElement{form, points.empty() ? "" : attribute_text("points", points)});
}

// Numbers that are 0 need no attribute, but for those of the place.
void TiledXmlEditor::edit_number(const pugi::xml_node& element, const char* name, double value) {
  const pugi::xml_attribute known = element.attribute(name);
  if (known.as_double() == value && (known || value == 0)) return;
  if (value == 0 && std::string_view(name).size() > 1)
    return remove_xml_attribute(places_, element, name, edits_);
  set_xml_attribute(places_, element, name, text_of_number(value), edits_);
}

void TiledXmlEditor::set_property(const pugi::xml_node& owner, const TiledPropertyEdit& edit) {
  Changes changes;
  edit_properties(owner, {edit}, changes);
  change_children(owner, changes);
}

TiledXmlEditor::NewElement TiledXmlEditor::new_property(const TiledPropertyEdit& edit) {
  const ValueText value = std::visit(ValueWriter(), *edit.value);
  const std::string type = value.type.empty() ? "" : attribute_text("type", value.type);
  return {"property", attribute_text("name", edit.name) + type + attribute_text("value", value.text)};
}

TiledXmlEditor::NewElement TiledXmlEditor::new_properties(const std::vector<TiledPropertyEdit>& edits) {
  NewElement list{"properties"};
  for (const TiledPropertyEdit& edit : edits) {
    if (edit.value) list.children.push_back(new_property(edit));
  }
  return list;
}

void TiledXmlEditor::edit_properties(const pugi::xml_node& owner, const std::vector<TiledPropertyEdit>& edits,
                                     Changes& changes) {
  const pugi::xml_node list = owner.child("properties");
  Changes of_list;
  for (const TiledPropertyEdit& edit : edits) {
    const pugi::xml_node known = list.find_child_by_attribute("property", "name", edit.name.c_str());
    const ValueText value = edit.value ? std::visit(ValueWriter(), *edit.value) : ValueText();
    if (edit.value && known.attribute("value") && takes_value(known.attribute("type").value(), value)) {
      set_xml_attribute(places_, known, "value", value.text, edits_);
      continue;
    }
    if (known) of_list.removed.push_back(known);
    if (edit.value) of_list.added.emplace_back(pugi::xml_node(), new_property(edit));
  }
  if (list) {
    const bool goes = of_list.added.empty() && !of_list.removed.empty() &&
                      of_list.removed.size() == elements_in(list).size();
    if (goes) return changes.removed.push_back(list);
    return change_children(list, of_list);
  }
  NewElement fresh = new_properties(edits);
  if (fresh.children.empty()) return;
  const std::vector<pugi::xml_node> elements = elements_in(owner);
  const pugi::xml_node first = elements.empty() ? pugi::xml_node() : elements.front();
  changes.added.emplace_back(first, std::move(fresh));
}

void TiledXmlEditor::change_children(const pugi::xml_node& parent, const Changes& changes) {
  if (changes.empty()) return;
  const std::vector<pugi::xml_node> elements = elements_in(parent);
  const std::string outer = places_.break_before(parent);
  if (elements.empty()) {
    const std::string line = outer.empty() ? "" : outer + unit_;
    std::string text;
    for (const auto& [before, element] : changes.added) text += line + print(element, line);
    const TextSpan inside = places_.inside(parent);
    if (places_.has_inside(parent) && is_blank_text(inside.in(text_)))
      return edits_.replace(inside, text + outer);
    return append_xml_inside(places_, parent, text + outer, edits_);
  }
  for (const pugi::xml_node& child : changes.removed) {
    const TextSpan whole = places_.whole(child);
    edits_.replace({whole.begin - places_.break_before(child).size(), whole.end}, "");
  }
  const std::string line = places_.break_before(elements.front());
  for (const auto& [next, element] : changes.added) {
    pugi::xml_node before = next;
    while (before && changes.removes(before)) before = element_after(before);
    if (before)
      edits_.insert(places_.whole(before).begin, print(element, line) + line);
    else
      edits_.insert(places_.whole(elements.back()).end, line + print(element, line));
  }
}

// line: the blanks before the element, from the line break on.
std::string TiledXmlEditor::print(const NewElement& element, const std::string& line) const {
  const std::string head = "<" + element.name + element.attributes;
  if (element.children.empty()) return head + "/>";
  const std::string inner = line.empty() ? "" : line + unit_;
  std::string text = head + ">";
  for (const NewElement& child : element.children) text += inner + print(child, inner);
  return text + line + "</" + element.name + ">";
}

}  // namespace talus
