#include "trace.h"

#include <string_view>
#include <vector>

#include "formats/text/append_number.h"

namespace talus {
namespace {

void append_pair(std::string& line, std::string_view key, Vec2 v) {
  line += key;
  line += "[";
  append_number(line, v.x);
  line += ",";
  append_number(line, v.y);
  line += "]";
}

void append_field(std::string& line, std::string_view key, double number) {
  line += key;
  append_number(line, number);
}

void append_body(std::string& line, const Body& body) {
  line += "{\"id\":";
  append_number(line, body.id);
  append_field(line, ",\"x\":", body.box.x);
  append_field(line, ",\"y\":", body.box.y);
  append_field(line, ",\"vx\":", body.velocity.x);
  append_field(line, ",\"vy\":", body.velocity.y);
  if (traits_of(body.kind).shape == BodyShape::circle) {
    append_field(line, ",\"spin\":", body.spin);
    append_field(line, ",\"turn\":", body.turn);
  }
  line += "}";
}

void append_slope(std::string& line, const SlopeProbe& slope) {
  append_field(line, ",\"slope\":{\"delta\":", slope.delta);
  append_field(line, ",\"floor\":", slope.floor_y);
  append_field(line, ",\"placed\":", slope.placed_y);
  append_pair(line, ",\"normal\":", slope.normal);
  line += slope.corrected ? ",\"corrected\":true}" : ",\"corrected\":false}";
}

std::string_view role_name(TileRole role) {
  if (role == TileRole::none) return "none";
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (info.role == role) return info.key;
  }
  return "";
}

std::string_view response_name(Response response) {
  switch (response) {
    case Response::touch:
      return "touch";
    case Response::cross:
      return "cross";
    case Response::slide:
      return "slide";
    case Response::bounce:
      return "bounce";
    default:
      return "";
  }
}

// The role of a tile, or the kind of a body: "solid", "crate". An edit after the step may have taken the body
// away.
std::string_view other_name(const State& state, const Obstacle& other) {
  if (other.body == 0) return role_name(other.role);
  const Body* const body = state.find(other.body);
  return body != nullptr ? traits_of(body->kind).word : "body";
}

void append_contact(std::string& line, const State& state, const ContactRecord& contact) {
  line += "{\"body\":";
  append_number(line, contact.body);
  line += ",\"other\":\"";
  line += other_name(state, contact.other);
  line += "\"";
  if (contact.other.body != 0) {
    line += ",\"other_body\":";
    append_number(line, contact.other.body);
  } else {
    line += ",\"cell\":[";
    append_number(line, contact.other.cell.x);
    line += ",";
    append_number(line, contact.other.cell.y);
    line += "]";
  }
  line += ",\"response\":\"";
  line += response_name(contact.response);
  line += contact.overlaps ? "\",\"overlaps\":true" : "\",\"overlaps\":false";
  append_field(line, ",\"ti\":", contact.ti);
  append_pair(line, ",\"move\":", contact.move);
  append_pair(line, ",\"normal\":", contact.normal);
  append_pair(line, ",\"touch\":", contact.touch);
  line += contact.handled ? ",\"handled\":true" : ",\"handled\":false";
  if (contact.slope) append_slope(line, *contact.slope);
  line += "}";
}

void append_event(std::string& line, const StepEvent& event) {
  line += "{\"kind\":\"";
  line += word_of(event.kind);
  append_field(line, "\",\"body\":", event.body);
  if (event.kind == StepEvent::Kind::hit) {
    append_field(line, ",\"other_body\":", event.other);
    append_pair(line, ",\"normal\":", event.normal);
    append_field(line, ",\"impulse\":", event.impulse);
  }
  line += "}";
}

// begin: the key, and the bracket that opens the list.
template <class Items, class Append>
void append_list(std::string& line, std::string_view begin, const Items& items, Append append_item) {
  line += begin;
  bool first = true;
  for (const auto& item : items) {
    if (!first) line += ",";
    first = false;
    append_item(line, item);
  }
  line += "]";
}

// The bodies whose path has this mark, if there are any.
void append_marked(std::string& line, std::string_view begin, const std::vector<BodyPath>& paths,
                   bool BodyPath::*mark) {
  std::vector<int> bodies;
  for (const BodyPath& path : paths) {
    if (path.*mark) bodies.push_back(path.body);
  }
  if (bodies.empty()) return;
  append_list(line, begin, bodies, [](std::string& text, int body) { append_number(text, body); });
}

}  // namespace

std::string trace_line(const State& state, const StepRecord* record, bool with_contacts) {
  std::string line = "{\"frame\":";
  append_number(line, state.frame);
  append_list(line, ",\"bodies\":[", state.bodies, append_body);
  const bool has_contacts = record != nullptr && with_contacts;
  const auto append = [&](std::string& text, const ContactRecord& c) { append_contact(text, state, c); };
  if (has_contacts) append_list(line, ",\"contacts\":[", record->contacts, append);
  if (record != nullptr && !record->events.empty())
    append_list(line, ",\"events\":[", record->events, append_event);
  if (has_contacts) {
    append_marked(line, ",\"capped\":[", record->paths, &BodyPath::capped);
    append_marked(line, ",\"cut_short\":[", record->paths, &BodyPath::cut_short);
  }
  line += "}";
  return line;
}

std::string hash_text(std::uint64_t hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (int i = 15; i >= 0; --i, hash >>= 4) text[i] = kDigits[hash & 15];
  return text;
}

}  // namespace talus
