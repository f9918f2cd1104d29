// Random maps of Tiled with random edits: saved, they are read as the edited level, and the text of all that
// was not edited stays.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <talus/formats/format.h>

namespace talus::save_tiled_property_test {

struct RandomMap {
  bool is_xml = true;
  std::string line;                  // how lines end, with the blanks before objects
  std::vector<std::string> objects;  // the text of each
  std::string text;
};

int number_below(int most) { return *rc::gen::inRange(0, most); }
std::string number_text() {
  return std::to_string(number_below(60)) + *rc::gen::element<std::string>("", ".5", ".25");
}

// The names of bodies and boxes are their numbers, so that each is known again.
std::string random_object(const RandomMap& map, int id) {
  const std::string name = std::to_string(id);
  const int form = number_below(4);
  if (map.is_xml) {
    const char quote = *rc::gen::element('"', '\'');
    const auto attribute = [&](const std::string& key, const std::string& value) {
      return " " + key + "=" + quote + value + quote;
    };
    const std::string head = "<object" + attribute("own", "a&lt;" + name) + attribute("id", name) +
                             attribute("name", name) + attribute("x", number_text()) +
                             attribute("y", number_text());
    if (form == 0)
      return head + attribute("type", "ball") + attribute("width", "4") + attribute("height", "5") + "/>";
    if (form == 1) return head + attribute("width", "7") + attribute("height", "3") + "><ellipse/></object>";
    if (form == 2) return head + "><!-- <object> --><polygon points=\"0,0 4,0 4,6\"/></object>";
    return head + "><properties><property name='p' value='1'/></properties><point /></object>";
  }
  const std::string head = "{\"own\":[1.50], \"id\":" + name + ", \"name\":\"" + name +
                           "\", \"x\":" + number_text() + ", \"y\":" + number_text();
  if (form == 0) return head + ", \"type\":\"ball\", \"width\":4, \"height\":5}";
  if (form == 1) return head + ", \"width\":7, \"height\":3, \"ellipse\":true}";
  if (form == 2) return head + ",\"polygon\":[{\"x\":0,\"y\":0},{\"x\":4,\"y\":0},{\"x\":4,\"y\":6}]}";
  return head + ", \"properties\":[{\"name\":\"p\",\"type\":\"string\",\"value\":\"1\"}], \"point\":true}";
}

RandomMap random_map() {
  RandomMap map;
  map.is_xml = *rc::gen::arbitrary<bool>();
  map.line = *rc::gen::element<std::string>("", "\n  ", "\r\n\t\t", "\n");
  const std::string offset = number_text();
  std::string layers;
  const int layer_count = number_below(4);
  int id = 1;
  for (int layer = 0; layer < layer_count; ++layer) {
    std::string objects;
    for (int count = number_below(5); count > 0; --count) {
      map.objects.push_back(random_object(map, id++));
      const bool is_first = objects.empty();
      objects += (map.is_xml || is_first ? "" : ",") + map.line + map.objects.back();
    }
    const std::string name = "l" + std::to_string(layer);
    if (map.is_xml)
      layers += "<group offsetx='" + offset + "'><objectgroup name='" + name + "'>" + objects +
                "</objectgroup></group>";
    else
      layers += ", {\"type\":\"objectgroup\", \"offsety\":" + offset + ", \"name\":\"" + name +
                "\", \"objects\":[" + objects + "]}";
  }
  const std::string next = std::to_string(id);
  if (map.is_xml)
    map.text =
        "<map orientation='orthogonal' width='9' height='9' tilewidth='8' tileheight='8' nextobjectid='" +
        next + "'><layer name='g' width='9' height='9'><data encoding='csv'></data></layer>" + layers +
        "</map>";
  else
    map.text =
        "{\"orientation\":\"orthogonal\", \"width\":9, \"height\":9, \"tilewidth\":8, \"tileheight\":8, "
        "\"nextobjectid\":" +
        next +
        ", \"layers\":[{\"type\":\"tilelayer\", \"name\":\"g\", \"width\":9, \"height\":9, \"data\":[]}" +
        layers + "]}";
  return map;
}

FormatContext context_of(const RandomMap& map) {
  return {.extension = map.is_xml ? "tmx" : "tmj", .folder = "."};
}

// Makes some edits. Adds the names of the bodies and objects that are touched.
void edit_at_random(Level& level, std::vector<std::string>& touched) {
  for (int edits = number_below(5); edits > 0; --edits) {
    const int what = number_below(8);
    if (what == 0) {
      level.spawns.push_back(
          {.name = "new", .position = {number_below(50) / 4.0, 3}, .velocity = {1.5, 0}, .extra = {}});
    } else if (what == 1) {
      level.curves.push_back({"c", {Arc{{24, 24}, 6, 19, 29, true}, Curve::Faces::both}, ""});
    } else if (what <= 3 && !level.spawns.empty()) {
      const auto i = static_cast<std::size_t>(number_below(static_cast<int>(level.spawns.size())));
      touched.push_back(level.spawns[i].name);
      if (what == 2)
        level.spawns.erase(level.spawns.begin() + static_cast<std::ptrdiff_t>(i));
      else
        level.spawns[i].position.x = number_below(200) / 8.0;
    } else if (!level.objects.empty()) {
      const auto layer = static_cast<std::size_t>(number_below(static_cast<int>(level.objects.size())));
      std::vector<MapObject>& objects = level.objects[layer].objects;
      if (what == 4) {
        level.objects[layer].name += "+";
      } else if (what == 5) {
        objects.insert(objects.begin(), {.name = "new", .position = {2, 3}, .size = {4, 5}});
      } else if (!objects.empty()) {
        const auto i = static_cast<std::size_t>(number_below(static_cast<int>(objects.size())));
        touched.push_back(objects[i].name);
        if (what == 6)
          objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(i));
        else
          objects[i].position.y = number_below(200) / 8.0;
      }
    }
  }
}

// Without layers that have no objects, as such a layer of a file may have bodies alone, and their groups.
std::pair<LayerGroups, std::vector<ObjectLayer>> with_objects(const Level& level) {
  TileLayers layers = level.layers;
  std::vector<ObjectLayer> objects = level.objects;
  std::erase_if(objects, [](const ObjectLayer& layer) { return layer.objects.empty(); });
  tidy_groups(layers, objects);
  return {layers.groups, objects};
}

RC_GTEST_PROP(SaveTiledAtRandom, GivesTheEditedLevelAndKeepsTheRest, ()) {
  const RandomMap map = random_map();
  const FormatContext context = context_of(map);
  auto loaded = read_level(map.text, context);
  RC_ASSERT(loaded.has_value());
  Level& level = loaded->level;
  std::vector<std::string> touched;
  edit_at_random(level, touched);
  const auto written = loaded->format->write(level, context);
  if (!written) RC_LOG() << written.error().message << "\n";
  RC_ASSERT(written.has_value());
  RC_LOG() << map.text << "\n" << written->bytes << "\n";
  const auto again = read_level(written->bytes, context);
  RC_ASSERT(again.has_value());
  RC_ASSERT(again->level.spawns == level.spawns);
  RC_ASSERT(again->level.curves == level.curves);
  RC_ASSERT(with_objects(again->level) == with_objects(level));
  for (std::size_t i = 0; i < map.objects.size(); ++i) {
    const bool is_touched = std::find(touched.begin(), touched.end(), std::to_string(i + 1)) != touched.end();
    if (!is_touched) RC_ASSERT(written->bytes.find(map.objects[i]) != std::string::npos);
  }
  if (touched.empty() && level == *written->held && written->bytes.size() == map.text.size())
    RC_ASSERT(written->bytes == map.text);
}

}  // namespace talus::save_tiled_property_test
