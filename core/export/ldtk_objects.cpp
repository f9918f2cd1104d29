#include "ldtk_objects.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include <talus/level/placed_picture.h>
#include "../formats/ldtk/ldtk_names.h"
#include "../formats/text/json_text.h"
#include "ldtk_shapes.h"

namespace talus {
namespace {

constexpr const char* kObjectColor = "#F77622";
constexpr int kFirstObjectIid = 1'000'000'000;  // above those of bodies

struct ObjectField {
  const char *key, *type;  // see ldtk_field()
};
// What each object has. Points are text, as LDtk would round them.
constexpr std::array<ObjectField, 14> kObjectFields = {{{"form", "String"},
                                                        {"class", "String"},
                                                        {"name", "String"},
                                                        {"x", "Float"},
                                                        {"y", "Float"},
                                                        {"w", "Float"},
                                                        {"h", "Float"},
                                                        {"tile", "Int"},
                                                        {"turn", "Int"},
                                                        {"rotation", "Float"},
                                                        {"points", "String"},
                                                        {"ground", "Bool"},
                                                        {"one_way", "Bool"},
                                                        {"hidden", "Bool"}}};

// Of what plain data leave out.
OrderedJson usual_value(std::string_view type) {
  if (type == "Bool") return false;
  return type == "Float" ? OrderedJson(0) : OrderedJson();
}

// TakenNames in use, and for each the last number that was added to it.
using TakenNames = std::map<std::string, int>;

std::string unique_name(const std::string& name, TakenNames& taken) {
  int& number = taken[name];
  if (number++ == 0) return name;
  for (;; ++number) {
    std::string numbered = name + "_" + std::to_string(number);
    if (taken.try_emplace(numbered, 1).second) return numbered;
  }
}

// The type of a field that holds the value exactly; all others are text.
std::string type_of_property(const OrderedJson& value) {
  if (value.is_boolean()) return "Bool";
  if (value.is_number_float()) return "Float";
  if (!value.is_number()) return "String";
  using Int = std::numeric_limits<std::int32_t>;
  const auto number = value.get<double>();
  return number >= Int::min() && number <= Int::max() ? "Int" : "String";
}

std::string joined_type(const std::string& a, const std::string& b) {
  if (a == b) return a;
  const bool are_numbers = (a == "Int" || a == "Float") && (b == "Int" || b == "Float");
  return are_numbers ? "Float" : "String";
}

OrderedJson value_of_field(const std::string& type, const OrderedJson& value) {
  if (type != "String" || value.is_string() || value.is_null()) return value;
  return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

// Around the points of a polygon or a polyline, or else the box of the object.
Rect box_of_object(const OrderedJson& json) {
  const auto number = [&](const char* key) { return json[key].get<double>(); };
  const auto points = json.find("points");
  if (points == json.end()) return {number("x"), number("y"), number("w"), number("h")};
  std::array<double, 2> least, most;
  least.fill(std::numeric_limits<double>::max());
  most.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < points->size(); ++i) {
    const double at = (*points)[i].get<double>();
    least[i % 2] = std::min(least[i % 2], at);
    most[i % 2] = std::max(most[i % 2], at);
  }
  return {least[0], least[1], most[0] - least[0], most[1] - least[1]};
}

}  // namespace

LdtkObjects::LdtkObjects(const Level& level, int first_uid) : level_(level), next_uid_(first_uid) {
  TakenNames names = {{"Bodies", 1}, {"Tiles", 1}, {"Collision", 1}};
  int next_iid = kFirstObjectIid;
  const auto order = layers_in_order(level);
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    if (at->has_tiles) continue;
    const ObjectLayer& layer = level.objects[static_cast<std::size_t>(at->index)];
    if (layer.image) continue;
    layers_.push_back({&layer, unique_name(ldtk_identifier(layer.name, "Objects"), names), next_uid_++,
                       next_iid++, layer.place <= 0});
    next_iid += static_cast<int>(layer.objects.size());
  }
  add_classes();
}

void LdtkObjects::add_classes() {
  for (const Layer& layer : layers_) {
    for (const MapObject& object : layer.source->objects) {
      Class& its = classes_[object.type];
      const OrderedJson properties = plain_properties(object.properties);
      for (const auto& [key, value] : properties.items()) {
        const std::string type = type_of_property(value);
        const auto [known, is_new] = its.properties.try_emplace(key, its.fields.size());
        if (is_new)
          its.fields.push_back({key, "", type});
        else
          its.fields[known->second].type = joined_type(its.fields[known->second].type, type);
      }
    }
  }
  TakenNames names;
  for (auto& [name, its] : classes_) {
    std::string wanted = ldtk_identifier(name, "Object");
    if (ldtk_body_of_name(wanted)) wanted += "_object";  // it would be a body to readers
    its.identifier = unique_name(wanted, names);
    its.uid = next_uid_;
    TakenNames keys;
    for (const ObjectField& field : kObjectFields) keys[field.key] = 1;
    for (Field& field : its.fields) field.identifier = unique_name(ldtk_identifier(field.key, "Field"), keys);
    next_uid_ += 1 + static_cast<int>(kObjectFields.size() + its.fields.size());
  }
}

std::vector<OrderedJson> LdtkObjects::definitions(const LdtkSkeleton& skeleton, int cell) const {
  std::vector<OrderedJson> all;
  for (const auto& [name, its] : classes_) {
    OrderedJson& made = all.emplace_back(skeleton.filled("entity_definition", {{"identifier", its.identifier},
                                                                               {"uid", its.uid},
                                                                               {"width", cell},
                                                                               {"height", cell},
                                                                               {"color", kObjectColor}}));
    int uid = its.uid;
    const auto add = [&](const std::string& identifier, const std::string& type) -> OrderedJson& {
      return made["fieldDefs"].emplace_back(skeleton.field_definition(identifier, type, ++uid));
    };
    for (const ObjectField& field : kObjectFields)
      add(field.key, field.type)["canBeNull"] = usual_value(field.type).is_null();
    for (const Field& field : its.fields) {
      OrderedJson& definition = add(field.identifier, field.type);
      definition["canBeNull"] = field.type != "Bool";
      if (field.identifier != field.key) definition["doc"] = field.key;
    }
  }
  return all;
}

OrderedJson LdtkObjects::entity(const Layer& layer, std::size_t index, int cell) const {
  const MapObject& object = layer.source->objects[index];
  const OrderedJson json = plain_object_json(level_, {layer.source, &object});
  const Class& its = classes_.at(object.type);
  const int iid = layer.iid + 1 + static_cast<int>(index);
  OrderedJson made = ldtk_entity({its.identifier, kObjectColor, its.uid, iid, box_of_object(json)}, cell);
  int uid = its.uid;
  for (const ObjectField& field : kObjectFields) {
    const auto found = json.find(field.key);
    const OrderedJson value =
        found == json.end() ? usual_value(field.type) : value_of_field(field.type, *found);
    made["fieldInstances"].push_back(ldtk_field(field.key, field.type, value, ++uid));
  }
  for (const auto& [key, value] : json.at("properties").items()) {
    const std::size_t number = its.properties.at(key);
    const Field& field = its.fields[number];
    made["fieldInstances"].push_back(ldtk_field(
        field.identifier, field.type, value_of_field(field.type, value), uid + 1 + static_cast<int>(number)));
  }
  return made;
}

}  // namespace talus
