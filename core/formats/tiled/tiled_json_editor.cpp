// Gathers what changes of the members of an object, and writes it at once.
#include "tiled_json_editor.h"

#include <algorithm>

namespace talus {
namespace {

std::string text_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

// "{"a":1, "b":2}", with the members as text.
class NewObject {
 public:
  NewObject& add(std::string_view key, const std::string& value) {
    if (!value.empty()) text_ += (text_.empty() ? "\"" : ", \"") + std::string(key) + "\":" + value;
    return *this;
  }
  NewObject& add(std::string_view key, const Json& value) { return add(key, text_of(value)); }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string in_brackets(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return "[" + text + "]";
}

struct PropertyWriter {
  std::string_view name;
  std::string operator()(bool value) const { return with("bool", value); }
  std::string operator()(std::int64_t value) const { return with("int", value); }
  std::string operator()(double value) const { return with("float", json_number(value)); }
  std::string operator()(const std::string& value) const { return with("string", value); }
  std::string with(const char* type, const Json& value) const {
    return NewObject().add("name", Json(name)).add("type", Json(type)).add("value", value).text();
  }
};

std::string new_properties(const std::vector<TiledPropertyEdit>& edits) {
  std::vector<std::string> values;
  for (const TiledPropertyEdit& edit : edits) {
    if (edit.value) values.push_back(std::visit(PropertyWriter{edit.name}, *edit.value));
  }
  return values.empty() ? "" : in_brackets(values);
}

std::string json_of_points(const std::vector<Vec2>& points) {
  std::vector<std::string> values;
  values.reserve(points.size());
  for (const Vec2 point : points)
    values.push_back(NewObject().add("x", json_number(point.x)).add("y", json_number(point.y)).text());
  return in_brackets(values);
}

const char* points_key(const TiledObject& object) {
  if (object.form == TiledObject::Form::polygon) return "polygon";
  return object.form == TiledObject::Form::polyline ? "polyline" : "";
}

}  // namespace

void TiledJsonEditor::edit_tiles(TextSpan tileset, const TiledTileEdits& edits) {
  const auto list = places_.member(tileset, "tiles");
  if (list && !places_.is_list(*list)) return;  // as Tiled wrote it before 1.2
  const std::vector<TextSpan> tiles = list ? places_.values(*list) : std::vector<TextSpan>();
  std::vector<int> ids;
  ids.reserve(tiles.size());
  for (const TextSpan tile : tiles) ids.push_back(places_.number_of(tile, "id"));
  JsonListEdit change;
  std::vector<std::string> all_new;
  for (const auto& [id, edit] : edits) {
    const auto same = std::find(ids.begin(), ids.end(), id);
    if (same != ids.end()) {
      edit_tile(tiles[static_cast<std::size_t>(same - ids.begin())], edit);
      continue;
    }
    const auto after = std::find_if(ids.begin(), ids.end(), [id = id](int other) { return other > id; });
    std::string tile = new_tile(id, edit);
    if (tile.empty()) continue;
    all_new.push_back(tile);
    change.added.emplace_back(static_cast<std::size_t>(after - ids.begin()), std::move(tile));
  }
  if (list)
    change_json_list(places_, *list, change, edits_);
  else if (!all_new.empty())
    set_json_member(places_, tileset, "tiles", in_brackets(all_new), edits_);
}

void TiledJsonEditor::edit_tile(TextSpan tile, const TiledTileEdit& edit) {
  std::vector<JsonMemberEdit> members;
  edit_properties(tile, edit.properties, members);
  const auto group = places_.member(tile, "objectgroup");
  if (group && !edit.objects.empty()) {
    const auto list = places_.member(*group, "objects");
    const auto removed =
        std::count_if(edit.objects.begin(), edit.objects.end(), [](const auto& o) { return o.removes; });
    const bool goes = list && static_cast<std::size_t>(removed) == edit.objects.size() &&
                      edit.objects.size() == places_.values(*list).size();
    if (goes)
      members.push_back({"objectgroup", std::nullopt});
    else
      edit_objects(*group, edit.objects);
  } else if (std::string objects = new_objects(edit.objects); !objects.empty()) {
    members.push_back({"objectgroup", std::move(objects)});
  }
  change_json_members(places_, tile, members, edits_);
}

std::string TiledJsonEditor::new_tile(int id, const TiledTileEdit& edit) const {
  const std::string objects = new_objects(edit.objects), properties = new_properties(edit.properties);
  if (objects.empty() && properties.empty()) return "";
  return NewObject().add("id", Json(id)).add("objectgroup", objects).add("properties", properties).text();
}

std::string TiledJsonEditor::new_objects(const std::vector<TiledObjectEdit>& edits) const {
  std::vector<std::string> values;
  for (const TiledObjectEdit& edit : edits) {
    if (edit.index < 0) values.push_back(new_object(edit, static_cast<int>(values.size()) + 1));
  }
  if (values.empty()) return "";
  return NewObject()
      .add("draworder", Json("index"))
      .add("name", Json(""))
      .add("objects", in_brackets(values))
      .add("opacity", Json(1))
      .add("type", Json("objectgroup"))
      .add("visible", Json(true))
      .add("x", Json(0))
      .add("y", Json(0))
      .text();
}

void TiledJsonEditor::edit_objects(TextSpan group, const std::vector<TiledObjectEdit>& edits) {
  const auto list = places_.member(group, "objects");
  if (!list || !places_.is_list(*list)) return;
  const std::vector<TextSpan> objects = places_.values(*list);
  int next_id = 1;
  for (const TextSpan object : objects) next_id = std::max(next_id, places_.number_of(object, "id") + 1);
  JsonListEdit change;
  for (const TiledObjectEdit& edit : edits) {
    const auto i = static_cast<std::size_t>(edit.index);
    if (edit.index < 0)
      change.added.emplace_back(objects.size(), new_object(edit, next_id++));
    else if (i < objects.size() && edit.removes)
      change.removed.push_back(i);
    else if (i < objects.size())
      edit_object(objects[i], edit);
  }
  change_json_list(places_, *list, change, edits_);
}

std::string TiledJsonEditor::type_key() const {
  const auto version = places_.member(root_, "version");
  return version && version->in(text_).find("1.9") != std::string_view::npos ? "class" : "type";
}

std::string TiledJsonEditor::new_object(const TiledObjectEdit& edit, int id) const {
  const TiledObject& object = *edit.object;
  NewObject text;
  text.add("height", json_number(object.size.y)).add("id", Json(id)).add("name", Json(object.name));
  if (object.form == TiledObject::Form::ellipse) text.add("ellipse", Json(true));
  if (const std::string key = points_key(object); !key.empty()) text.add(key, json_of_points(object.points));
  return text.add("properties", new_properties(edit.properties))
      .add("rotation", json_number(object.rotation))
      .add(type_key(), Json(object.type))
      .add("visible", Json(true))
      .add("width", json_number(object.size.x))
      .add("x", json_number(object.position.x))
      .add("y", json_number(object.position.y))
      .text();
}

void TiledJsonEditor::edit_object(TextSpan object, const TiledObjectEdit& edit) {
  std::vector<JsonMemberEdit> members;
  edit_properties(object, edit.properties, members);
  if (edit.object) {
    const TiledObject& now = *edit.object;
    const auto set = [&](const std::string& key, const Json& value, const Json& usual) {
      const auto known = places_.member(object, key);
      const Json old = known ? Json::parse(known->in(text_), nullptr, false) : usual;
      if (old != value) members.push_back({key, text_of(value)});
    };
    set("name", now.name, "");
    if (!now.type.empty())
      set(places_.member(object, "class")  ? "class"
          : places_.member(object, "type") ? "type"
                                           : type_key(),
          now.type, "");
    set("x", json_number(now.position.x), nullptr);
    set("y", json_number(now.position.y), nullptr);
    set("width", json_number(now.size.x), 0);
    set("height", json_number(now.size.y), 0);
    set("rotation", json_number(now.rotation), 0);
    const std::string key = points_key(now);
    const bool is_point = now.form == TiledObject::Form::box && now.size == Vec2();
    for (const char* form : {"polygon", "polyline", "ellipse", "point", "text", "capsule"}) {
      const bool stays = form == key || (is_point && std::string_view(form) == "point") ||
                         (now.form == TiledObject::Form::ellipse && std::string_view(form) == "ellipse");
      if (!stays) members.push_back({form, std::nullopt});
    }
    if (!key.empty()) members.push_back({key, json_of_points(now.points)});
  }
  change_json_members(places_, object, members, edits_);
}

void TiledJsonEditor::set_property(TextSpan owner, const TiledPropertyEdit& edit) {
  std::vector<JsonMemberEdit> members;
  edit_properties(owner, {edit}, members);
  change_json_members(places_, owner, members, edits_);
}

void TiledJsonEditor::edit_properties(TextSpan owner, const std::vector<TiledPropertyEdit>& edits,
                                      std::vector<JsonMemberEdit>& members) {
  const auto list = places_.member(owner, "properties");
  if (list && !places_.is_list(*list)) return;  // as Tiled wrote it before 1.2
  if (!list) {
    if (std::string fresh = new_properties(edits); !fresh.empty())
      members.push_back({"properties", std::move(fresh)});
    return;
  }
  const std::vector<TextSpan> properties = places_.values(*list);
  JsonListEdit change;
  for (const TiledPropertyEdit& edit : edits) {
    const auto known = std::find_if(properties.begin(), properties.end(), [&](TextSpan property) {
      return places_.text_of(property, "name") == edit.name;
    });
    const auto i = static_cast<std::size_t>(known - properties.begin());
    const std::string text = edit.value ? std::visit(PropertyWriter{edit.name}, *edit.value) : "";
    if (known == properties.end()) {
      if (edit.value) change.added.emplace_back(properties.size(), text);
      continue;
    }
    const Json now = edit.value ? Json::parse(text) : Json();
    const auto value = places_.member(*known, "value");
    if (!edit.value)
      change.removed.push_back(i);
    else if (value && places_.text_of(*known, "type", "string") == now["type"])
      edits_.replace(*value, text_of(now["value"]));
    else
      edits_.replace(*known, text);
  }
  if (change.added.empty() && !properties.empty() && change.removed.size() == properties.size())
    members.push_back({"properties", std::nullopt});
  else
    change_json_list(places_, *list, change, edits_);
}

}  // namespace talus
