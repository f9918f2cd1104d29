// Fields of the chosen object.
#include "object_inspector.h"

#include <optional>
#include <utility>

#include "chosen_object.h"
#include "edit/object_handles.h"
#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"
#include "panels/ui/shown_text.h"
#include "panels/ui/text_field.h"

namespace talus {
namespace {

constexpr float kObjectField = 150;     // px at scale 1
constexpr std::size_t kMaxOfName = 40;  // bytes

// The object with these properties, of which `one_way` is a field of its own, too.
MapObject with_properties(MapObject object, std::string properties) {
  const Json all = properties_in(properties);
  object.properties = std::move(properties);
  const auto one_way = all.find("one_way");
  object.one_way = one_way != all.end() && *one_way == true;
  return object;
}

void change_chosen(const Session& session, MapObject object, std::string label, int stroke,
                   Actions& actions) {
  const ObjectRef chosen = session.choices().object;
  if (const auto problem = problem_of_layer(session.level(), chosen.layer))
    return actions.push_back(action::ShowMessage{*problem, true});
  if (const auto problem = problem_of_object(object))
    return actions.push_back(action::ShowMessage{"Not changed: the object " + *problem + ".", true});
  actions.push_back(
      action::EditLevel{change_object(session.level(), chosen, std::move(object), std::move(label)), stroke});
}

}  // namespace

void ObjectInspector::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_kind(session, actions, ui);
  draw_layer(session, actions, ui);
  const MapObject* const object = chosen_object(session);
  const ObjectRef chosen = session.choices().object;
  if (object == nullptr) {
    shown_ = {};
    ui.hint("No object chosen: click one on the map, or drag to draw another.");
    return;
  }
  if (chosen != shown_) {
    name_ = object->name;
    type_ = object->type;
    properties_.forget();
  }
  ui.heading("Object " + std::to_string(chosen.index + 1) + ", " + std::string(word_of_form(*object)));
  ui.begin_row();
  draw_texts(session, *object, actions, ui);
  draw_numbers(session, *object, actions, ui);
  ui.end_row();
  draw_properties(session, *object, actions, ui);
  command_text_button("map/duplicate"_command, session, actions, ui,
                      {.widget = "inspector/object_duplicate"});
  ImGui::SameLine();
  if (ui.text_button("inspector/object_remove", "Remove", false, "Removes the object from the level.",
                     keys_of("map/delete"_command, ui)))
    delete_object(session, actions);
  shown_ = chosen;
}

void ObjectInspector::draw_kind(const Session& session, Actions& actions, Ui& ui) const {
  const ObjectKind now = session.choices().object_kind;
  ui.begin_row();
  ui.label("A drag draws");
  ImGui::SameLine();
  if (ui.begin_combo("inspector/object_kind", std::string(label_of(now)), ui.px(96),
                     "The form of the next object; the tool's key goes on to the next one. The corners of a "
                     "polygon are clicked one by one.")) {
    for (int i = 0; i < kObjectKindCount; ++i) {
      const auto kind = static_cast<ObjectKind>(i);
      const std::string label(label_of(kind));
      if (selectable(label, {}, kind == now)) actions.push_back(action::SetObjectKind{kind});
      ui.item("inspector/object_kind_" + label);
    }
    ImGui::EndCombo();
  }
  ui.end_row();
}

// The layer that gets new objects.
void ObjectInspector::draw_layer(const Session& session, Actions& actions, Ui& ui) const {
  const Level& level = session.level();
  const int count = static_cast<int>(level.objects.size());
  if (count == 0) return;
  const int chosen = session.choices().object.layer;
  const int now = chosen >= 0 && chosen < count ? chosen : count - 1;
  ui.begin_row();
  ui.label("in the layer");
  ImGui::SameLine();
  if (ui.begin_combo("inspector/object_layer", shown_line(object_layer_text(level, now), kMaxOfName),
                     ui.px(kObjectField), "The layer of objects that new ones come into.")) {
    draw_rows(count, [&](int layer) {
      ImGui::PushID(layer);
      if (selectable(shown_line(object_layer_text(level, layer), kMaxOfName), {}, layer == now))
        actions.push_back(action::SelectObject{{layer, -1}});
      ui.item("inspector/object_layer_" + std::to_string(layer));
      ImGui::PopID();
    });
    ImGui::EndCombo();
  }
  ui.end_row();
}

void ObjectInspector::draw_texts(const Session& session, const MapObject& object, Actions& actions, Ui& ui) {
  const auto field = [&](const std::string& part, std::string_view title, std::string& typed,
                         std::string MapObject::*member, const char* help, const char* label) {
    const std::string name = "inspector/object_" + part, hint = "no " + part;
    if (!draw_text_field({title, name, hint, help}, typed, object.*member, ui)) return;
    MapObject changed = object;
    changed.*member = typed;
    change_chosen(session, std::move(changed), label, 0, actions);
  };
  field("name", "Name", name_, &MapObject::name, "The name of this object.", "Name an object");
  field("class", "Class", type_, &MapObject::type, "What games take it for, in Tiled its class.",
        "Change an object's class");
}

void ObjectInspector::draw_numbers(const Session& session, const MapObject& object, Actions& actions,
                                   Ui& ui) {
  MapObject changed = object;
  bool has_changed = false;
  const auto number = [&](const std::string& part, double& value, const char* help) {
    const std::string name = "inspector/object_" + part, format = part + " %.8g";
    has_changed |=
        draw_number_field({name, format.c_str(), help, kFormField, 1}, value, session, number_, ui);
  };
  ui.field_label("Place");
  number("x", changed.position.x, "px, of its place.");
  ImGui::SameLine();
  number("y", changed.position.y, "px, of its place.");
  if (object.points.empty() && object.size != Vec2()) {
    ui.field_label("Size");
    number("w", changed.size.x, "Its width, px.");
    ImGui::SameLine();
    number("h", changed.size.y, "Its height, px.");
  }
  ui.field_label("Turned");
  number("turn", changed.rotation, "Degrees, clockwise about its place.");
  if (has_changed) change_chosen(session, changed, "Change an object", number_.stroke, actions);
  ui.field_label("");
  bool one_way = object.one_way;
  if (ImGui::Checkbox("one-way", &one_way)) {
    const PropertyChange change{"one_way", one_way ? std::optional<Json>(true) : std::nullopt};
    change_chosen(session, with_properties(object, with_property(object.properties, change)),
                  "Change an object's one-way side", 0, actions);
  }
  ui.item("inspector/object_one_way", "Whether it stops only what comes from above, if its layer is ground.");
}

void ObjectInspector::draw_properties(const Session& session, const MapObject& object, Actions& actions,
                                      Ui& ui) {
  std::optional<std::string> wrong;
  const auto change = properties_.draw("inspector/object", "object", object.properties, "one_way", wrong, ui);
  if (wrong) actions.push_back(action::ShowMessage{*wrong, true});
  if (!change) return;
  change_chosen(session, with_properties(object, with_property(object.properties, *change)),
                "Change an object's properties", 0, actions);
}

}  // namespace talus
