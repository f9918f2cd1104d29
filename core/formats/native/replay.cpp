#include "replay.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>

#include <talus/collision/world.h>
#include "../text/append_number.h"
#include "../text/json_text.h"

namespace talus {
namespace {

using Name = std::int64_t;

// An operation that is not written as the header says; thrown and caught in this file only.
struct Malformed {
  std::string message;
};

const Json& field(const Json& op, const char* key) {
  const auto it = op.find(key);
  if (it == op.end()) throw Malformed{std::string("\"") + key + "\" is missing."};
  return *it;
}

Name name_field(const Json& op) {
  const Json& item = field(op, "item");
  constexpr std::int64_t kMin = std::numeric_limits<Name>::min(), kMax = std::numeric_limits<Name>::max();
  if (!is_whole(item, kMin, kMax)) throw Malformed{"\"item\" must be an integer."};
  return item.get<Name>();
}

const Json& array_field(const Json& op, const char* key, std::size_t size) {
  const Json& array = field(op, key);
  if (!array.is_array() || array.size() > size) {
    throw Malformed{std::string("\"") + key + "\" must be an array of " + std::to_string(size) + " numbers."};
  }
  return array;
}

Vec2 point_field(const Json& op, const char* key) {
  const Json& array = array_field(op, key, 2);
  if (array.size() != 2 || !array[0].is_number() || !array[1].is_number()) {
    throw Malformed{std::string("\"") + key + "\" must be an array of 2 numbers."};
  }
  return {array[0].get<double>(), array[1].get<double>()};
}

const Json& element(const Json& array, std::size_t index) {
  static const Json kNull;
  return index < array.size() ? array[index] : kNull;
}

// Lua's tostring and type of a value that is not a number.
std::pair<std::string, std::string> lua_value(const Json& value) {
  if (value.is_null()) return {"nil", "nil"};
  if (value.is_string()) return {value.get<std::string>(), "string"};
  if (value.is_boolean()) return {value.get<bool>() ? "true" : "false", "boolean"};
  return {"table", "table"};
}

double coordinate(const Json& value, const std::string& name) {
  if (value.is_number()) return value.get<double>();
  const auto [text, type] = lua_value(value);
  throw WorldError(name + " must be a number, but was " + text + "(a " + type + ")");
}

double size(const Json& value, const std::string& name) {
  if (value.is_number()) return value.get<double>();
  const auto [text, type] = lua_value(value);
  throw WorldError(name + " must be a positive integer, but was " + text + "(" + type + ")");
}

Rect rect_field(const Json& op) {
  const Json& array = array_field(op, "rect", 4);
  return {coordinate(element(array, 0), "x"), coordinate(element(array, 1), "y"),
          size(element(array, 2), "w"), size(element(array, 3), "h")};
}

void append_pair(std::string& line, const char* key, Vec2 v) {
  line += key;
  append_number(line, v.x);
  line += ',';
  append_number(line, v.y);
  line += ']';
}

// All but ASCII is escaped: names may have characters that move the text of a terminal.
std::string error_line(const char* message) {
  return "{\"error\":" + Json(message).dump(-1, ' ', /*ensure_ascii=*/true) + "}";
}

class Replay {
 public:
  // Unknown responses share one of the world, which has no bound for their number.
  explicit Replay(double cell_size)
      : world_(cell_size),
        unknown_(world_.add_response(
            "",
            [this](const World&, Collision& hit, Rect, Vec2, World::Filter, std::vector<Collision>&) -> Vec2 {
              throw WorldError(unknown_response_message(reaction_to(hit.other).name));
            })) {}
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  // The work so far.
  std::int64_t looks() const { return world_.looks(); }

  std::string answer(const Json& op) {
    if (!op.is_object()) throw Malformed{"An operation must be an object."};
    const Json& kind = field(op, "op");
    struct Row {
      const char* kind;
      std::string (Replay::*run)(const Json& op);
    };
    static constexpr std::array<Row, 11> kRows{
        {{"add", &Replay::add},
         {"update", &Replay::update},
         {"remove", &Replay::remove},
         {"getRect", &Replay::get_rect},
         {"move", &Replay::move},
         {"check", &Replay::check},
         {"queryRect", &Replay::query_rect},
         {"queryPoint", &Replay::query_point},
         {"querySegment", &Replay::query_segment},
         {"querySegmentWithCoords", &Replay::query_segment_with_coords},
         {"toCell", &Replay::to_cell}}};
    const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return kind == r.kind; });
    if (row == kRows.end())
      throw Malformed{"Unknown operation " + (kind.is_string() ? kind.dump() : "of that kind") + "."};
    try {
      return (this->*row->run)(op);
    } catch (const WorldError& error) {
      return error_line(error.what());
    }
  }

 private:
  ItemId item_named(Name name) const {
    const auto it = ids_.find(name);
    if (it == ids_.end()) throw WorldError(item_not_added_message(std::to_string(name)));
    return it->second;
  }
  Name name_of(ItemId item) const { return names_[item.index]; }

  std::string add(const Json& op) {
    const Name name = name_field(op);
    if (ids_.contains(name)) throw WorldError(item_added_twice_message(std::to_string(name)));
    const ItemId item = world_.add(rect_field(op));
    ids_[name] = item;
    if (names_.size() <= item.index) names_.resize(item.index + 1);
    names_[item.index] = name;
    return "{\"ok\":true}";
  }

  std::string update(const Json& op) {
    const ItemId item = item_named(name_field(op));
    const Json& array = array_field(op, "rect", 4);
    Rect rect = world_.rect(item);
    rect.x = coordinate(element(array, 0), "x");
    rect.y = coordinate(element(array, 1), "y");
    if (!element(array, 2).is_null()) rect.w = size(element(array, 2), "w");
    if (!element(array, 3).is_null()) rect.h = size(element(array, 3), "h");
    world_.update(item, rect);
    return "{\"ok\":true}";
  }

  std::string remove(const Json& op) {
    const Name name = name_field(op);
    world_.remove(item_named(name));
    ids_.erase(name);
    return "{\"ok\":true}";
  }

  std::string get_rect(const Json& op) {
    const Rect rect = world_.rect(item_named(name_field(op)));
    std::string line;
    append_pair(line, "{\"rect\":[", rect.position());
    line.back() = ',';
    append_pair(line, "", {rect.w, rect.h});
    return line + "}";
  }

  // A goal coordinate that is null stands for the old one, and stays null unless a response sets it.
  struct Arrival {
    std::optional<double> x;
    std::optional<double> y;
  };

  Arrival arrive(const Json& op) {
    const ItemId item = item_named(name_field(op));
    const Json& array = array_field(op, "goal", 2);
    const Rect rect = world_.rect(item);
    const auto axis = [&](std::size_t index, double old) {
      const Json& value = element(array, index);
      if (!value.is_number() && !value.is_null()) throw Malformed{"\"goal\" must be an array of 2 numbers."};
      return value.is_null() ? old : value.get<double>();
    };
    const Vec2 goal{axis(0, rect.x), axis(1, rect.y)};
    read_filter(op);
    const Vec2 at = world_.check(
        item, goal, [this](ItemId, ItemId other) { return reaction_to(other).response; }, hits_);
    const bool set = std::any_of(hits_.begin(), hits_.end(),
                                 [](const Collision& hit) { return hit.response != Response::cross; });
    Arrival arrival;
    if (set || !element(array, 0).is_null()) arrival.x = at.x;
    if (set || !element(array, 1).is_null()) arrival.y = at.y;
    return arrival;
  }

  std::string move(const Json& op) {
    const Arrival at = arrive(op);
    const auto axis = [](std::optional<double> v, const char* name) { return v ? *v : coordinate({}, name); };
    world_.update(item_named(name_field(op)), Vec2{axis(at.x, "x"), axis(at.y, "y")});
    return arrival_line(at);
  }

  std::string check(const Json& op) { return arrival_line(arrive(op)); }

  std::string arrival_line(const Arrival& at) const {
    std::string line = "{\"x\":";
    at.x ? append_number(line, *at.x) : void(line += "null");
    line += ",\"y\":";
    at.y ? append_number(line, *at.y) : void(line += "null");
    line += ",\"cols\":[";
    for (const Collision& hit : hits_) {
      if (&hit != hits_.data()) line += ',';
      append_collision(line, hit);
    }
    return line + "]}";
  }

  void append_collision(std::string& line, const Collision& hit) const {
    const std::string type(world_.response_name(hit.response));
    line += "{\"other\":";
    append_number(line, name_of(hit.other));
    line += ",\"type\":\"" + type + "\",\"overlaps\":" + (hit.overlaps ? "true" : "false") + ",\"ti\":";
    append_number(line, hit.ti);
    append_pair(line, ",\"move\":[", hit.move);
    append_pair(line, ",\"normal\":[", hit.normal);
    append_pair(line, ",\"touch\":[", hit.touch);
    if (hit.aim) append_pair(line, (",\"" + type + "\":[").c_str(), *hit.aim);
    line += '}';
  }

  struct Reaction {
    Response response = Response::slide;
    std::string name = {};  // as the filter has it, for an unknown response
  };

  // An unknown name is an error only when a contact needs it.
  Reaction reaction_named(const Json& value) const {
    if (value.is_null()) return {Response::ignore};
    if (!value.is_string()) throw Malformed{"A filter must answer with the name of a response or null."};
    const auto name = value.get<std::string>();
    return {world_.find_response(name).value_or(unknown_), name};
  }

  void read_filter(const Json& op) {
    reactions_.clear();
    default_reaction_ = {};
    const auto it = op.find("filter");
    if (it == op.end() || it->is_null()) return;
    if (!it->is_object()) throw Malformed{"\"filter\" must be an object."};
    default_reaction_ = {Response::ignore};
    for (const auto& [key, value] : it->items())
      (key == "default" ? default_reaction_ : reactions_[key]) = reaction_named(value);
  }
  const Reaction& reaction_to(ItemId other) const {
    const auto it = reactions_.find(std::to_string(name_of(other)));
    return it == reactions_.end() ? default_reaction_ : it->second;
  }

  std::string names_line(const std::vector<Name>& names) const {
    std::string line = "{\"items\":[";
    for (const Name name : names) {
      append_number(line, name);
      line += ',';
    }
    if (!names.empty()) line.pop_back();
    return line + "]}";
  }
  std::string found_line() const {
    std::vector<Name> names;
    for (const ItemId item : found_) names.push_back(name_of(item));
    std::sort(names.begin(), names.end());
    return names_line(names);
  }

  std::string query_rect(const Json& op) {
    world_.query_rect(rect_field(op), found_);
    return found_line();
  }
  std::string query_point(const Json& op) {
    world_.query_point(point_field(op, "point"), found_);
    return found_line();
  }
  std::string query_segment(const Json& op) {
    world_.query_segment(point_field(op, "from"), point_field(op, "to"), segment_hits_);
    std::vector<Name> names;
    for (const SegmentHit& hit : segment_hits_) names.push_back(name_of(hit.item));
    return names_line(names);
  }
  std::string query_segment_with_coords(const Json& op) {
    world_.query_segment(point_field(op, "from"), point_field(op, "to"), segment_hits_);
    std::string line = "{\"items\":[";
    const auto append_field = [&line](const char* key, double v) {
      line += key;
      append_number(line, v);
    };
    for (const SegmentHit& hit : segment_hits_) {
      if (&hit != segment_hits_.data()) line += ',';
      line += "{\"item\":";
      append_number(line, name_of(hit.item));
      append_field(",\"ti1\":", hit.ti1);
      append_field(",\"ti2\":", hit.ti2);
      append_field(",\"x1\":", hit.enter.x);
      append_field(",\"y1\":", hit.enter.y);
      append_field(",\"x2\":", hit.leave.x);
      append_field(",\"y2\":", hit.leave.y);
      line += '}';
    }
    return line + "]}";
  }

  std::string to_cell(const Json& op) {
    const Cell cell = world_.to_cell(point_field(op, "point"));
    return "{\"cell\":[" + std::to_string(cell.x) + "," + std::to_string(cell.y) + "]}";
  }

  World world_;
  Response unknown_;
  std::map<Name, ItemId> ids_;
  std::vector<Name> names_;  // by the index of the item
  std::map<std::string, Reaction, std::less<>> reactions_;
  Reaction default_reaction_;
  std::vector<Collision> hits_;
  std::vector<ItemId> found_;
  std::vector<SegmentHit> segment_hits_;
};

}  // namespace

FormatResult<void> replay_scenario(std::string_view json, const TakeAnswer& take, std::int64_t most_looks) {
  std::string place;
  try {
    const FormatResult<Json> parsed = parse_json(json);
    if (!parsed) return tl::unexpected(parsed.error());
    const Json& scenario = *parsed;
    if (!scenario.is_object()) throw Malformed{"A scenario must be an object."};
    const Json cell_size = scenario.value("cell_size", Json(64));
    if (!cell_size.is_number()) throw Malformed{"\"cell_size\" must be a number."};
    Replay replay(cell_size.get<double>());
    const Json& ops = field(scenario, "ops");
    if (!ops.is_array()) throw Malformed{"\"ops\" must be an array."};
    for (std::size_t i = 0; i < ops.size(); ++i) {
      place = "op " + std::to_string(i + 1);
      if (!take(replay.answer(ops[i]))) break;
      if (replay.looks() > most_looks)
        throw Malformed{"The operations up to here test more than " + std::to_string(most_looks) +
                        " cells and boxes."};
    }
    return {};
  } catch (const Malformed& malformed) {
    return tl::unexpected(FormatError{place, malformed.message});
  } catch (const WorldError& error) {
    return tl::unexpected(FormatError{place, error.what()});
  } catch (const Json::exception&) {
    return tl::unexpected(FormatError{place, "A number is too large, or a text is not UTF-8."});
  }
}

}  // namespace talus
