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

std::string json_of_frames(const std::vector<TiledTile::Frame>& frames) {
  std::vector<std::string> values;
  values.reserve(frames.size());
  for (const auto& [id, duration] : frames)
    values.push_back(NewObject().add("duration", Json(duration)).add("tileid", Json(id)).text());
  return in_brackets(values);
}

const char* points_key(const TiledObject& object) {
  if (object.form == TiledObject::Form::polygon) return "polygon";
  return object.form == TiledObject::Form::polyline ? "polyline" : "";
}

void edit_form(const TiledObject& now, std::vector<JsonMemberEdit>& members) {
  const std::string key = points_key(now);
  for (const char* form : {"polygon", "polyline", "ellipse", "point", "text", "capsule"}) {
    const bool stays = form == key || (is_point(now) && std::string_view(form) == "point") ||
                       (now.form == TiledObject::Form::ellipse && std::string_view(form) == "ellipse");
    if (!stays) members.push_back({form, std::nullopt});
  }
  if (!key.empty()) members.push_back({key, json_of_points(now.points)});
}

// Whether a property of this type in the file can hold a value of that type.
bool type_takes(const std::string& type, const std::string& of_value) {
  if (of_value == "string") return type == "string" || type == "color" || type == "file";
  if (of_value == "int") return type == "int" || type == "object" || type == "float";
  return type == of_value;
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
  if (edit.probability) members.push_back({"probability", text_of(json_number(*edit.probability))});
  if (edit.type) {
    const auto type = edit.type->empty() ? std::nullopt : std::optional(text_of(Json(*edit.type)));
    members.push_back({type_key_of(tile), type});
  }
  if (edit.animation) {
    const auto frames =
        edit.animation->empty() ? std::nullopt : std::optional(json_of_frames(*edit.animation));
    members.push_back({"animation", frames});
  }
  const auto group = places_.member(tile, "objectgroup");
  if (group && !edit.objects.empty()) {
    const auto list = places_.member(*group, "objects");
    int id = 1;
    for (const TextSpan object : list ? places_.values(*list) : std::vector<TextSpan>())
      id = std::max(id, places_.number_of(object, "id") + 1);
    const auto removed =
        std::count_if(edit.objects.begin(), edit.objects.end(), [](const auto& o) { return o.removes; });
    const bool goes = list && static_cast<std::size_t>(removed) == edit.objects.size() &&
                      edit.objects.size() == places_.values(*list).size();
    if (goes)
      members.push_back({"objectgroup", std::nullopt});
    else
      edit_objects(*group, edit.objects, [&] { return id++; });
  } else if (std::string objects = new_objects(edit.objects); !objects.empty()) {
    members.push_back({"objectgroup", std::move(objects)});
  }
  change_json_members(places_, tile, members, edits_);
}

std::string TiledJsonEditor::new_tile(int id, const TiledTileEdit& edit) const {
  const std::string objects = new_objects(edit.objects), properties = new_properties(edit.properties);
  const std::string probability = edit.probability ? text_of(json_number(*edit.probability)) : "";
  const std::string type = edit.type && !edit.type->empty() ? text_of(Json(*edit.type)) : "";
  const std::string animation =
      edit.animation && !edit.animation->empty() ? json_of_frames(*edit.animation) : "";
  if ((objects + properties + probability + type + animation).empty()) return "";
  return NewObject()
      .add("animation", animation)
      .add("id", Json(id))
      .add("objectgroup", objects)
      .add("probability", probability)
      .add("properties", properties)
      .add(type_key(), type)
      .text();
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

void TiledJsonEditor::edit_objects(TextSpan group, const std::vector<TiledObjectEdit>& edits,
                                   const std::function<int()>& next_id) {
  const auto list = places_.member(group, "objects");
  if (!list) {
    std::vector<std::string> all;
    for (const TiledObjectEdit& edit : edits) {
      if (edit.index < 0) all.push_back(new_object(edit, next_id()));
    }
    return set_json_member(places_, group, "objects", in_brackets(all), edits_);
  }
  if (!places_.is_list(*list)) return;
  const std::vector<TextSpan> objects = places_.values(*list);
  JsonListEdit change;
  for (const TiledObjectEdit& edit : edits) {
    const auto i = static_cast<std::size_t>(edit.index);
    if (edit.index < 0)
      change.added.emplace_back(edit.at < 0 ? objects.size() : static_cast<std::size_t>(edit.at),
                                new_object(edit, next_id()));
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
  if (object.form == TiledObject::Form::tile) text.add("gid", Json(object.gid));
  if (is_point(object)) text.add("point", Json(true));
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
    for (JsonMemberEdit& member :
         edit.before ? differences(object, *edit.before, *edit.object) : all_of(object, *edit.object))
      members.push_back(std::move(member));
  }
  change_json_members(places_, object, members, edits_);
}

std::string TiledJsonEditor::type_key_of(TextSpan object) const {
  if (places_.member(object, "class")) return "class";
  return places_.member(object, "type") ? "type" : type_key();
}

// Those that differ from what the object says.
std::vector<JsonMemberEdit> TiledJsonEditor::all_of(TextSpan object, const TiledObject& now) const {
  std::vector<JsonMemberEdit> members;
  const auto set = [&](const std::string& key, const Json& value, const Json& usual) {
    const auto known = places_.member(object, key);
    const Json old = known ? json_part(known->in(text_)) : usual;
    if (old != value) members.push_back({key, text_of(value)});
  };
  set("name", now.name, "");
  if (!now.type.empty()) set(type_key_of(object), now.type, "");
  set("x", json_number(now.position.x), nullptr);
  set("y", json_number(now.position.y), nullptr);
  set("width", json_number(now.size.x), 0);
  set("height", json_number(now.size.y), 0);
  set("rotation", json_number(now.rotation), 0);
  edit_form(now, members);
  return members;
}

std::vector<JsonMemberEdit> TiledJsonEditor::differences(TextSpan object, const TiledObject& before,
                                                         const TiledObject& now) const {
  std::vector<JsonMemberEdit> members;
  const auto set = [&](const std::string& key, const auto& old, const auto& value) {
    if (old != value) members.push_back({key, text_of(value)});
  };
  set("name", Json(before.name), Json(now.name));
  set(type_key_of(object), Json(before.type), Json(now.type));
  set("gid", Json(before.gid), Json(now.gid));
  set("visible", Json(before.visible), Json(now.visible));
  set("x", json_number(before.position.x), json_number(now.position.x));
  set("y", json_number(before.position.y), json_number(now.position.y));
  set("width", json_number(before.size.x), json_number(now.size.x));
  set("height", json_number(before.size.y), json_number(now.size.y));
  set("rotation", json_number(before.rotation), json_number(now.rotation));
  if (now.form != before.form || now.points != before.points || is_point(now) != is_point(before))
    edit_form(now, members);
  return members;
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
    const Json now = edit.value ? json_part(text) : Json();
    const auto value = places_.member(*known, "value");
    if (!edit.value)
      change.removed.push_back(i);
    else if (value && type_takes(places_.text_of(*known, "type", "string"), now["type"].get<std::string>()))
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
