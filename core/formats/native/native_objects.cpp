// One list of members for each kind of object serves reading and writing.
#include "native_objects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <talus/level/limits.h>
#include "native_members.h"

namespace talus {
namespace {

constexpr double kMaxSpawnNumber = 100'000'000;  // px and px/frame; six times the longest map

constexpr std::array<std::string_view, 6> kShapeKinds = {"none",    "solid",   "slope",
                                                         "profile", "polygon", "group"};
constexpr std::array<std::string_view, 2> kSides = {"floor", "ceiling"};
constexpr std::array<std::string_view, 6> kForms = {"segment", "arc",  "parabola",  // as Curve::form
                                                    "cubic",   "sine", "polyline"};
constexpr std::array<std::string_view, 3> kFaces = {"up", "down", "both"};
constexpr std::array<std::string_view, 2> kFeet = {"box", "centre"};

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

// Looks at each coordinate of a curve alone, so that an error has its key. problem_of() looks at the whole.
class ReachChecker {
 public:
  explicit ReachChecker(MemberTaker& take) : take_(take) {}
  void operator()(std::string_view key, double coordinate) {
    constexpr std::array<std::string_view, 4> kNoPlaces = {"radius", "amplitude", "from_slope", "to_slope"};
    if (std::find(kNoPlaces.begin(), kNoPlaces.end(), key) == kNoPlaces.end()) check(key, coordinate);
  }
  void operator()(std::string_view key, Vec2 point) {
    check(key, point.x);
    check(key, point.y);
  }
  void operator()(std::string_view key, const std::vector<double>& heights) {
    if (heights.size() < 2 || heights.size() > kMaxPolylineHeights)
      take_.fail(key, "must have 2 to 65536 heights");
    for (const double height : heights) check(key, height);
  }

 private:
  void check(std::string_view key, double coordinate) {
    if (!(std::abs(coordinate) <= kMaxCoordinate))
      take_.fail(key, "reaches further than 16777216 px from the origin");
  }

  MemberTaker& take_;
};

template <std::size_t... I>
void set_form(Curve& curve, std::size_t index, std::index_sequence<I...>) {
  ((I == index ? void(curve.form.emplace<I>()) : void()), ...);
}

FormatResult<LevelCurve> take_curve(Json& json, const std::string& path, const TileMap& map) {
  MemberTaker take(json, path);
  LevelCurve curve;
  take.optional("name", curve.name);
  std::size_t form = 0;
  if (!take.choice("kind", kForms, form)) take.fail("kind", choice_text(kForms));
  set_form(curve.curve, form, std::make_index_sequence<std::variant_size_v<decltype(Curve::form)>>());
  take.choice("faces", kFaces, curve.curve.faces);
  take.optional("conveyor", curve.curve.conveyor);
  std::visit([&](auto& members) { list_members(take, members); }, curve.curve.form);
  if (Arc* arc = std::get_if<Arc>(&curve.curve.form)) take.optional("upper", arc->upper);
  ReachChecker reach(take);
  std::visit([&](auto& members) { list_members(reach, members); }, curve.curve.form);
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
  if (curve.curve.conveyor != 0) (*json)["conveyor"] = curve.curve.conveyor;
  MemberPutter put(*json);
  auto form = curve.curve.form;  // a copy: the list of members takes references, as readers need
  std::visit([&](auto& members) { list_members(put, members); }, form);
  if (const Arc* arc = std::get_if<Arc>(&form); arc != nullptr && !arc->upper) (*json)["upper"] = false;
  return json;
}

std::vector<std::string_view> body_words() {
  std::vector<std::string_view> words;
  for (const BodyTraits& traits : body_kinds()) words.push_back(traits.word);
  return words;
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

// All but the parts of a group.
TileShape take_simple_shape(MemberTaker& take) {
  TileShape shape;
  take.choice("kind", kShapeKinds, shape.kind);
  take.choice("side", kSides, shape.side);
  take.optional("one_way", shape.one_way);
  take.optional("tiles", shape.tiles);
  take.optional("heights", shape.heights);
  take.optional("points", shape.points);
  return shape;
}

// A part of a group. Its other members could not be kept.
FormatResult<TileShape> take_group_part(Json& json, const std::string& path, TileSize tile) {
  MemberTaker take(json, path);
  take.require("kind");
  TileShape shape = take_simple_shape(take);
  std::optional<std::string> problem = problem_of(shape, tile);
  if (shape.kind == TileShape::Kind::group) problem = "is a group, which a part cannot be";
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no part has";
  return take.result(std::move(shape), std::move(problem));
}

void put_members(const TileShape& shape, Json& json) {
  if (shape.kind != TileShape::Kind::none) json["kind"] = kShapeKinds[static_cast<std::size_t>(shape.kind)];
  if (shape.side != TileShape::Side::floor) json["side"] = kSides[static_cast<std::size_t>(shape.side)];
  if (shape.one_way) json["one_way"] = true;
  if (shape.tiles != 1) json["tiles"] = shape.tiles;
  if (!shape.heights.empty()) MemberPutter{json}("heights", shape.heights);
  if (!shape.points.empty()) MemberPutter{json}("points", shape.points);
  if (shape.conveyor != 0) json["conveyor"] = shape.conveyor;
  for (const TileShape& part : shape.parts) put_members(part, json["parts"].emplace_back(Json::object()));
}

}  // namespace

FormatResult<TileShape> take_shape(Json& json, const std::string& path, TileSize tile) {
  MemberTaker take(json, path);
  TileShape shape = take_simple_shape(take);
  take.optional("conveyor", shape.conveyor);
  std::optional<FormatError> wrong_part;
  take.member("parts", [&](const Json& list) {
    Json parts = list;
    const auto take_part = [&](Json& part, const std::string& entry) {
      return take_group_part(part, entry, tile);
    };
    auto taken = take_list<TileShape>(parts, path + ".parts", take_part, kMaxGroupParts,
                                      "must be a list of up to 64 shapes");
    if (taken)
      shape.parts = *std::move(taken);
    else
      wrong_part = taken.error();
  });
  if (wrong_part) return tl::unexpected(*std::move(wrong_part));
  auto problem = problem_of(shape, tile);
  return take.result(std::move(shape), std::move(problem));
}

FormatResult<void> put_shape(const TileShape& shape, const std::string& path, TileSize tile, Json& json) {
  if (auto problem = problem_of(shape, tile))
    return tl::unexpected(FormatError{"key " + path, *std::move(problem)});
  put_members(shape, json);
  return {};
}

FormatResult<std::vector<LevelCurve>> take_curves(Json& list, const std::string& path, const TileMap& map) {
  const auto take = [&](Json& json, const std::string& entry) { return take_curve(json, entry, map); };
  return take_list<LevelCurve>(list, path, take, kMaxCurves, "must be a list of up to 16384 curves");
}

FormatResult<Json> json_of(const std::vector<LevelCurve>& curves, const std::string& path,
                           const TileMap& map) {
  return put_list(curves, path, [&](const LevelCurve& curve, const std::string& entry) {
    return json_of(curve, entry, map);
  });
}

namespace {

constexpr const char* kSpritesWord = "sprites";  // of a picture on that sheet; pictures of tiles have no key

// Whether the value is [first, second], whole numbers from those least ones to these most ones.
bool is_whole_pair(const Json& pair, int least_first, int most_first, int most_second) {
  return pair.is_array() && pair.size() == 2 && is_whole(pair[0], least_first, most_first) &&
         is_whole(pair[1], 1, most_second);
}

// {"sheet": "sprites", "size": [columns, rows], "steps": n, "stand": [first image, frames], ...}
FormatResult<BodyPicture> take_body_picture(Json json, const std::string& path) {
  MemberTaker take(json, path);
  BodyPicture picture;
  take.member("sheet", [&](const Json& word) {
    if (word != kSpritesWord) return take.fail("sheet", "must be \"sprites\"; without it, it is the tiles");
    picture.sheet = SheetId::sprites;
  });
  take.member("size", [&](const Json& size) {
    if (!is_whole_pair(size, 1, kMaxBodyPictureSide, kMaxBodyPictureSide))
      return take.fail("size", "must be [columns, rows], each from 1 to 16 tiles");
    picture.columns = size[0].get<std::uint8_t>();
    picture.rows = size[1].get<std::uint8_t>();
  });
  take.member("steps", [&](const Json& steps) {
    if (!is_whole(steps, 1, kMaxFrameSteps))
      return take.fail("steps", range_text(1, kMaxFrameSteps, "", true));
    picture.steps = steps.get<std::uint16_t>();
  });
  for (std::size_t act = 0; act < kBodyActWords.size(); ++act) {
    const std::string key(kBodyActWords[act]);
    take.member(key.c_str(), [&](const Json& frames) {
      if (!is_whole_pair(frames, 0, kMaxTiles - 1, kMaxBodyFrames))
        return take.fail(key, "must be [tile, frames], with a tile from 0 to 65535 and 1 to 32 frames");
      picture.acts[act] = {frames[0].get<TileNumber>(), frames[1].get<std::uint8_t>()};
    });
  }
  std::optional<std::string> problem;
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no picture of a body has";
  return take.result(std::move(picture), std::move(problem));
}

Json json_of(const BodyPicture& picture) {
  Json json = Json::object();
  if (picture.sheet == SheetId::sprites) json["sheet"] = kSpritesWord;
  if (picture.columns != 1 || picture.rows != 1) json["size"] = {picture.columns, picture.rows};
  if (picture.steps != BodyPicture().steps) json["steps"] = picture.steps;
  for (std::size_t act = 0; act < picture.acts.size(); ++act)
    if (const auto& [first, count] = picture.acts[act]; count > 0)
      json[std::string(kBodyActWords[act])] = {first, count};
  return json;
}

}  // namespace

FormatResult<Spawn> take_spawn(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  Spawn spawn;
  take.optional("name", spawn.name);
  for (const SpawnNumber& n : kSpawnNumbers)
    take.ranged(n.key, -kMaxSpawnNumber, kMaxSpawnNumber, "", spawn.*n.vector.*n.part);
  take.choice("kind", body_words(), spawn.kind);
  spawn.size = traits_of(spawn.kind).size;
  take.size("size", spawn.size);
  Foot foot = Foot::box;
  if (take.choice("foot", kFeet, foot)) spawn.foot = foot;
  std::optional<FormatError> wrong_picture;
  take.member("picture", [&](const Json& value) {
    const auto picture = take_body_picture(value, path + ".picture");
    if (picture)
      spawn.picture = *picture;
    else
      wrong_picture = picture.error();
  });
  if (wrong_picture) return tl::unexpected(*std::move(wrong_picture));
  spawn.extra = take.rest();
  return take.result(std::move(spawn));
}

FormatResult<Json> json_of(const Spawn& spawn, const std::string& path) {
  auto json = parse_extra(spawn.extra);
  if (!json) return json;
  (*json)["name"] = spawn.name;
  for (const SpawnNumber& n : kSpawnNumbers) (*json)[n.key] = json_number(spawn.*n.vector.*n.part);
  if (spawn.kind != Spawn().kind) (*json)["kind"] = traits_of(spawn.kind).word;
  if (spawn.size != traits_of(spawn.kind).size) MemberPutter{*json}("size", spawn.size);
  if (spawn.foot) (*json)["foot"] = kFeet[static_cast<std::size_t>(*spawn.foot)];
  if (spawn.picture != BodyPicture()) (*json)["picture"] = json_of(spawn.picture);
  Json copy = *json;  // what a reader would refuse is not written
  if (const auto good = take_spawn(copy, path); !good) return tl::unexpected(good.error());
  return json;
}

FormatResult<std::vector<Spawn>> take_spawns(Json& list, const std::string& path) {
  return take_list<Spawn>(list, path, take_spawn, kMaxSpawns, "must be a list of up to 65536 bodies");
}

FormatResult<Json> json_of(const std::vector<Spawn>& spawns, const std::string& path) {
  return put_list(spawns, path,
                  [](const Spawn& spawn, const std::string& entry) { return json_of(spawn, entry); });
}

}  // namespace talus
