// One list of members a kind of object, for reading and for writing.
#include "native_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace talus {
namespace {

constexpr double kMaxSpawnNumber = 100'000'000;  // px and px/frame; six times the longest map

using Names = std::span<const std::string_view>;  // of an enum's values, in order

constexpr std::array<std::string_view, 4> kShapeKinds = {"none", "solid", "slope", "profile"};
constexpr std::array<std::string_view, 2> kSides = {"floor", "ceiling"};
constexpr std::array<std::string_view, 6> kForms = {"segment", "arc",  "parabola",  // as Curve::form
                                                    "cubic",   "sine", "polyline"};
constexpr std::array<std::string_view, 3> kFaces = {"up", "down", "both"};
constexpr std::array<std::string_view, 2> kBodyKinds = {"ball", "player"};
constexpr std::array<std::string_view, 2> kFeet = {"box", "centre"};

std::string choice_text(Names names) {
  std::string text = "must be ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text.append("\"").append(names[i]).append("\"");
  }
  return text;
}

// Takes members out of an object and remembers the first error.
class Taker {
 public:
  Taker(Json& json, const std::string& path) : json_(json), path_(path) {
    if (!json.is_object()) fail("", "must be an object");
  }

  // A member that must be there.
  template <class Value>
  void operator()(const char* key, Value& value) {
    if (!error_ && !json_.contains(key)) return fail(key, "is missing");
    optional(key, value);
  }
  // One that keeps its value if it is not.
  template <class Value>
  void optional(const char* key, Value& value) {
    take(key, [&](const Json& json) { read(json, key, value); });
  }
  // Whether the member is there and one of the names.
  template <class Enum>
  bool choice(const char* key, Names names, Enum& value) {
    bool chosen = false;
    take(key, [&](const Json& json) {
      const auto found = std::find(names.begin(), names.end(), json);
      if (found == names.end()) return fail(key, choice_text(names));
      value = static_cast<Enum>(found - names.begin());
      chosen = true;
    });
    return chosen;
  }
  void ranged(const char* key, double min, double max, std::string_view unit, double& value) {
    take(key, [&](const Json& json) {
      if (!is_in(json, min, max)) return fail(key, range_text(min, max, unit));
      value = json.get<double>();
    });
  }
  void size(const char* key, Vec2& value) {
    take(key, [&](const Json& json) {
      const bool good = json.is_array() && json.size() == 2 && is_in(json[0], kMinBodySize, kMaxBodySize) &&
                        is_in(json[1], kMinBodySize, kMaxBodySize);
      if (!good) return fail(key, "must be [width, height], each from 0.00390625 to 1024 px");
      value = {json[0].get<double>(), json[1].get<double>()};
    });
  }
  void fail(std::string_view key, std::string message) {
    const std::string place = key.empty() ? path_ : path_ + "." + std::string(key);
    if (!error_) error_ = FormatError{"key " + place, std::move(message)};
  }

  // The value, unless something was wrong with a member, or is with the whole.
  template <class Value>
  FormatResult<Value> result(Value value, std::optional<std::string> problem = {}) {
    if (problem) fail("", *std::move(problem));
    if (error_) return tl::unexpected(*error_);
    return value;
  }
  // The members that nobody took.
  std::string rest() const { return json_.empty() ? "" : json_.dump(); }

 private:
  template <class Read>
  void take(const char* key, Read read) {
    if (error_) return;
    const auto found = json_.find(key);
    if (found == json_.end()) return;
    read(std::as_const(*found));
    json_.erase(key);
  }

  static bool is_in(const Json& json, double min, double max) {
    return json.is_number() && json.get<double>() >= min && json.get<double>() <= max;
  }
  static bool are_numbers(const Json& json) {
    return json.is_array() &&
           std::all_of(json.begin(), json.end(), [](const Json& v) { return v.is_number(); });
  }

  void read(const Json& json, const char* key, double& value) {
    if (!json.is_number()) return fail(key, "must be a number");
    value = json.get<double>();
  }
  void read(const Json& json, const char* key, int& value) {
    if (!json.is_number_integer() || json < -999 || json > 999) return fail(key, "must be a whole number");
    value = json.get<int>();
  }
  void read(const Json& json, const char* key, bool& value) {
    if (!json.is_boolean()) return fail(key, "must be true or false");
    value = json.get<bool>();
  }
  void read(const Json& json, const char* key, std::string& value) {
    if (!json.is_string()) return fail(key, "must be a string");
    value = json.get<std::string>();
  }
  void read(const Json& json, const char* key, Vec2& value) {
    if (!are_numbers(json) || json.size() != 2) return fail(key, "must be a point [x, y]");
    value = {json[0].get<double>(), json[1].get<double>()};
  }
  void read(const Json& json, const char* key, std::vector<double>& values) {
    if (!are_numbers(json)) return fail(key, "must be a list of numbers");
    values = json.get<std::vector<double>>();
  }

  Json& json_;
  const std::string& path_;
  std::optional<FormatError> error_;
};

// Sets members of an object; the counterpart of Taker.
class Putter {
 public:
  explicit Putter(Json& json) : json_(json) {}
  void operator()(const char* key, double value) { json_[key] = json_number(value); }
  void operator()(const char* key, Vec2 value) { json_[key] = {json_number(value.x), json_number(value.y)}; }
  void operator()(const char* key, const std::vector<double>& values) {
    Json& list = json_[key] = Json::array();
    for (const double value : values) list.push_back(json_number(value));
  }

 private:
  Json& json_;
};

template <class Io>
void list_members(Io& io, Segment& s) {
  io("from", s.from);
  io("to", s.to);
}
template <class Io>
void list_members(Io& io, Arc& a) {
  io("center", a.center);
  io("radius", a.radius);
  io("x0", a.x0);
  io("x1", a.x1);
}
template <class Io>
void list_members(Io& io, Parabola& p) {
  io("from", p.from);
  io("to", p.to);
  io("control_y", p.control_y);
}
template <class Io>
void list_members(Io& io, Cubic& c) {
  io("from", c.from);
  io("to", c.to);
  io("from_slope", c.from_slope);
  io("to_slope", c.to_slope);
}
template <class Io>
void list_members(Io& io, Sine& s) {
  io("x0", s.x0);
  io("x1", s.x1);
  io("middle", s.middle);
  io("amplitude", s.amplitude);
  io("wavelength", s.wavelength);
  io("origin", s.origin);
}
template <class Io>
void list_members(Io& io, Polyline& p) {
  io("x0", p.x0);
  io("x1", p.x1);
  io("ys", p.ys);
}

template <std::size_t... I>
void set_form(Curve& curve, std::size_t index, std::index_sequence<I...>) {
  ((I == index ? void(curve.form.emplace<I>()) : void()), ...);
}

FormatResult<LevelCurve> take_curve(Json& json, const std::string& path, const TileMap& map) {
  Taker take(json, path);
  LevelCurve curve;
  take.optional("name", curve.name);
  std::size_t form = 0;
  if (!take.choice("kind", kForms, form)) take.fail("kind", choice_text(kForms));
  set_form(curve.curve, form, std::make_index_sequence<std::variant_size_v<decltype(Curve::form)>>());
  take.choice("faces", kFaces, curve.curve.faces);
  std::visit([&](auto& members) { list_members(take, members); }, curve.curve.form);
  if (Arc* arc = std::get_if<Arc>(&curve.curve.form)) take.optional("upper", arc->upper);
  if (const auto bad = take.result(true); !bad) return tl::unexpected(bad.error());
  curve.extra = take.rest();
  auto problem = problem_of(curve.curve, map);
  return take.result(std::move(curve), std::move(problem));
}

FormatResult<Json> json_of(const LevelCurve& curve, const std::string& path, const TileMap& map) {
  if (auto problem = problem_of(curve.curve, map))
    return tl::unexpected(FormatError{"key " + path, *std::move(problem)});
  auto json = parse_extra(curve.extra);
  if (!json) return json;
  if (!curve.name.empty()) (*json)["name"] = curve.name;
  (*json)["kind"] = kForms[curve.curve.form.index()];
  if (curve.curve.faces != Curve::Faces::up)
    (*json)["faces"] = kFaces[static_cast<std::size_t>(curve.curve.faces)];
  Putter put(*json);
  auto form = curve.curve.form;  // a copy: one list of members serves readers, who change them
  std::visit([&](auto& members) { list_members(put, members); }, form);
  if (const Arc* arc = std::get_if<Arc>(&form); arc != nullptr && !arc->upper) (*json)["upper"] = false;
  return json;
}

struct SpawnNumber {
  const char* key;
  Vec2 Spawn::*vector;
  double Vec2::*part;
};
constexpr std::array<SpawnNumber, 4> kSpawnNumbers = {{{"x", &Spawn::position, &Vec2::x},
                                                       {"y", &Spawn::position, &Vec2::y},
                                                       {"vx", &Spawn::velocity, &Vec2::x},
                                                       {"vy", &Spawn::velocity, &Vec2::y}}};

FormatResult<Spawn> take_spawn(Json& json, const std::string& path) {
  Taker take(json, path);
  Spawn spawn;
  take.optional("name", spawn.name);
  for (const SpawnNumber& n : kSpawnNumbers)
    take.ranged(n.key, -kMaxSpawnNumber, kMaxSpawnNumber, "", spawn.*n.vector.*n.part);
  take.choice("kind", kBodyKinds, spawn.kind);
  take.size("size", spawn.size);
  Foot foot = Foot::box;
  if (take.choice("foot", kFeet, foot)) spawn.foot = foot;
  if (const auto bad = take.result(true); !bad) return tl::unexpected(bad.error());
  spawn.extra = take.rest();
  return spawn;
}

FormatResult<Json> json_of(const Spawn& spawn, const std::string& path) {
  auto json = parse_extra(spawn.extra);
  if (!json) return json;
  (*json)["name"] = spawn.name;
  for (const SpawnNumber& n : kSpawnNumbers) (*json)[n.key] = json_number(spawn.*n.vector.*n.part);
  if (spawn.kind != BodyKind::ball) (*json)["kind"] = kBodyKinds[static_cast<std::size_t>(spawn.kind)];
  if (spawn.size != Spawn().size) Putter{*json}("size", spawn.size);
  if (spawn.foot) (*json)["foot"] = kFeet[static_cast<std::size_t>(*spawn.foot)];
  Json copy = *json;  // what a reader would refuse is not written
  if (const auto good = take_spawn(copy, path); !good) return tl::unexpected(good.error());
  return json;
}

// Reads each entry of a list with take(entry, path of the entry).
template <class Value, class Take>
FormatResult<std::vector<Value>> take_list(Json& list, const std::string& path, Take take) {
  if (!list.is_array()) return tl::unexpected(FormatError{"key " + path, "must be a list"});
  std::vector<Value> values;
  values.reserve(list.size());
  for (Json& json : list) {
    auto value = take(json, path + "[" + std::to_string(values.size()) + "]");
    if (!value) return tl::unexpected(value.error());
    values.push_back(*std::move(value));
  }
  return values;
}

// Its counterpart: put(value, path) makes each entry.
template <class Value, class Put>
FormatResult<Json> put_list(const std::vector<Value>& values, const std::string& path, Put put) {
  Json list = Json::array();
  for (const Value& value : values) {
    auto json = put(value, path + "[" + std::to_string(list.size()) + "]");
    if (!json) return json;
    list.push_back(*std::move(json));
  }
  return list;
}

}  // namespace

FormatResult<TileShape> take_shape(Json& json, const std::string& path) {
  Taker take(json, path);
  TileShape shape;
  take.choice("kind", kShapeKinds, shape.kind);
  take.choice("side", kSides, shape.side);
  take.optional("one_way", shape.one_way);
  take.optional("tiles", shape.tiles);
  take.optional("heights", shape.heights);
  auto problem = problem_of(shape);
  return take.result(std::move(shape), std::move(problem));
}

FormatResult<void> put_shape(const TileShape& shape, const std::string& path, Json& json) {
  if (auto problem = problem_of(shape))
    return tl::unexpected(FormatError{"key " + path, *std::move(problem)});
  if (shape.kind != TileShape::Kind::none) json["kind"] = kShapeKinds[static_cast<std::size_t>(shape.kind)];
  if (shape.side != TileShape::Side::floor) json["side"] = kSides[static_cast<std::size_t>(shape.side)];
  if (shape.one_way) json["one_way"] = true;
  if (shape.tiles != 1) json["tiles"] = shape.tiles;
  if (!shape.heights.empty()) Putter{json}("heights", shape.heights);
  return {};
}

FormatResult<std::vector<LevelCurve>> take_curves(Json& list, const std::string& path, const TileMap& map) {
  return take_list<LevelCurve>(
      list, path, [&](Json& json, const std::string& entry) { return take_curve(json, entry, map); });
}

FormatResult<Json> json_of(const std::vector<LevelCurve>& curves, const std::string& path,
                           const TileMap& map) {
  return put_list(curves, path, [&](const LevelCurve& curve, const std::string& entry) {
    return json_of(curve, entry, map);
  });
}

FormatResult<std::vector<Spawn>> take_spawns(Json& list, const std::string& path) {
  return take_list<Spawn>(list, path, take_spawn);
}

FormatResult<Json> json_of(const std::vector<Spawn>& spawns, const std::string& path) {
  return put_list(spawns, path,
                  [](const Spawn& spawn, const std::string& entry) { return json_of(spawn, entry); });
}

std::string range_text(double min, double max, std::string_view unit, bool whole) {
  std::string text = whole ? "must be a whole number from " : "must be a number from ";
  text += json_number(min).dump() + " to " + json_number(max).dump();  // "64", not "64.000000"
  return unit.empty() ? text : text + " " + std::string(unit);
}

FormatResult<Json> parse_extra(const std::string& extra) {
  if (extra.empty()) return Json::object();
  auto json = parse_json(extra);
  if (!json || !json->is_object())
    return tl::unexpected(FormatError{"", "the level's unknown keys are no JSON object"});
  return json;
}

}  // namespace talus
