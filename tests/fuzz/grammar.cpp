// Both writers walk the good document, and choose at each step whether to change something there.
#include "fuzz/grammar.h"
#include "paths.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <utility>

namespace talus {
namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, 26> kJsonValues = {"null",
                                                     "true",
                                                     "false",
                                                     "0",
                                                     "-1",
                                                     "1",
                                                     "0.5",
                                                     "-0.0",
                                                     "1e-320",
                                                     "1e308",
                                                     "-1e308",
                                                     "1e999",
                                                     "NaN",
                                                     "255",
                                                     "2147483648",
                                                     "4294967295",
                                                     "9223372036854775807",
                                                     "9223372036854775808",
                                                     "18446744073709551116",
                                                     "-9223372036854775808",
                                                     "\"\"",
                                                     "\"x\"",
                                                     "\"\\n::error::\\u001b[31m\"",
                                                     "\"\\u0000\\ud800\"",
                                                     "[]",
                                                     "{}"};
constexpr std::array<const char*, 18> kXmlValues = {"",
                                                    "0",
                                                    "-1",
                                                    "1",
                                                    "0.5",
                                                    "255",
                                                    "x",
                                                    "true",
                                                    "NaN",
                                                    "inf",
                                                    "1e308",
                                                    "1e999",
                                                    "4294967295",
                                                    "9223372036854775808",
                                                    "&#xD800;",
                                                    "&#10;::error::&#27;[31m",
                                                    "&#0;&unknown;",
                                                    "0,0 1e308,1e308 -1,x"};
// Elements of Tiled's XML by their names in its JSON. As names in XML they must not mean the same.
constexpr std::array<const char*, 8> kJsonNamesOfElements = {"layers",     "tilesets",    "tiles", "objects",
                                                             "properties", "objectgroup", "data",  "chunks"};

std::string nested(RandomBytes& choices, const std::string& value) {
  constexpr std::array<std::size_t, 4> kDepths = {2, 30, 70, 20'000};
  const std::size_t depth = kDepths[choices.below(kDepths.size())];
  std::string text;
  const bool is_list = choices.below(2) == 0;
  for (std::size_t i = 0; i < depth; ++i) text += is_list ? "[" : "{\"keys\":";
  text += value;
  return text.append(depth, is_list ? ']' : '}');
}

class JsonWriter {
 public:
  JsonWriter(const std::vector<std::string>& names, const std::vector<std::string>& values,
             RandomBytes& choices)
      : names_(names), values_(values), choices_(choices), rarity_(8U << choices.below(5)) {}

  std::string take() { return std::move(text_); }

  void write(const ordered_json& value) {
    switch (change(5)) {
      case 1:
        text_ += kJsonValues[choices_.below(kJsonValues.size())];
        return;
      case 2:
        text_ += values_[choices_.index(values_.size())];
        return;
      case 3:
        text_ += nested(choices_, value.is_primitive() ? value.dump() : "1");
        return;
      case 4:
        text_ += "\"" + std::string(choices_.index(5000), 'A') + "\"";
        return;
      default:
        break;
    }
    if (value.is_object())
      write_members(value);
    else if (value.is_array())
      write_list(value);
    else
      text_ += value.dump();
  }

 private:
  // Returns 0 mostly, or 1..kinds-1.
  unsigned change(unsigned kinds) { return choices_.below(rarity_) == 1 ? 1 + choices_.below(kinds - 1) : 0; }

  void write_list(const ordered_json& list) {
    text_ += "[";
    const char* separator = "";
    const auto add = [&](const ordered_json& value) {
      text_ += std::exchange(separator, ",");
      write(value);
    };
    for (const ordered_json& value : list) {
      const unsigned what = change(3);
      if (what != 1) add(value);
      if (what == 2) add(value);
    }
    text_ += "]";
  }

  void write_members(const ordered_json& object) {
    text_ += "{";
    const char* separator = "";
    const auto add = [&](const std::string& key, const ordered_json& value) {
      text_.append(std::exchange(separator, ",")).append(ordered_json(key).dump()).append(":");
      write(value);
    };
    for (const auto& [key, value] : object.items()) {
      const unsigned what = change(5);
      const std::string& other = names_[choices_.index(what < 3 ? 1 : names_.size())];
      if (what != 1) add(what == 3 ? other : key, value);
      if (what == 2) add(key, value);
      if (what == 4) add(other, value);
    }
    text_ += "}";
  }

  const std::vector<std::string>& names_;
  const std::vector<std::string>& values_;
  RandomBytes& choices_;
  unsigned rarity_;
  std::string text_;
};

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '"')
      escaped += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      escaped += c;
  }
  return escaped;
}

class XmlWriter {
 public:
  XmlWriter(const std::vector<std::string>& names, const std::vector<std::string>& values,
            RandomBytes& choices)
      : names_(names), values_(values), choices_(choices), rarity_(8U << choices.below(5)) {}

  std::string take() { return std::move(text_); }

  void write(const pugi::xml_node& node) {
    if (node.type() != pugi::node_element) {
      text_ += changed_value(node.value());
      return;
    }
    const std::string name = change(2) == 1 ? any_name() : node.name();
    const unsigned depth = change(40) == 39 ? 20'000 : 0;
    for (unsigned i = 0; i < depth; ++i) text_ += "<" + name + ">";
    text_ += "<" + name;
    for (const pugi::xml_attribute attribute : node.attributes()) write_attribute(attribute);
    if (change(2) == 1) text_ += " " + any_name() + "=\"" + changed_value("1") + "\"";
    text_ += ">";
    if (change(2) == 1) text_ += "<" + any_name() + "/>";
    for (const pugi::xml_node child : node.children()) {
      const unsigned what = change(3);
      if (what != 1) write(child);
      if (what == 2) write(child);
    }
    if (change(2) == 1) text_ += "<" + any_name() + " name=\"x\"/>";
    text_ += "</" + name + ">";
    for (unsigned i = 0; i < depth; ++i) text_ += "</" + name + ">";
  }

 private:
  unsigned change(unsigned kinds) { return choices_.below(rarity_) == 1 ? 1 + choices_.below(kinds - 1) : 0; }
  const std::string& any_name() { return names_[choices_.index(names_.size())]; }

  void write_attribute(const pugi::xml_attribute& attribute) {
    const unsigned what = change(4);
    if (what == 1) return;
    const std::string name = what == 2 ? any_name() : attribute.name();
    for (int i = what == 3 ? 2 : 1; i > 0; --i)
      text_ += " " + name + "=\"" + changed_value(attribute.value()) + "\"";
  }

  std::string changed_value(const char* value) {
    switch (change(4)) {
      case 1:
        return kXmlValues[choices_.below(kXmlValues.size())];
      case 2:
        return values_[choices_.index(values_.size())];
      case 3:
        return std::string(choices_.index(5000), 'A');
      default:
        return xml_escaped(value);
    }
  }

  const std::vector<std::string>& names_;
  const std::vector<std::string>& values_;
  RandomBytes& choices_;
  unsigned rarity_;
  std::string text_;
};

void collect(const ordered_json& value, std::set<std::string>& names, std::set<std::string>& values) {
  if (value.is_structured()) {
    for (const auto& [key, member] : value.items()) {
      if (value.is_object()) names.insert(key);
      collect(member, names, values);
    }
  }
  constexpr std::size_t kShort = 200;
  if (std::string text = value.dump(); text.size() < kShort) values.insert(std::move(text));
}

void collect(const pugi::xml_node& node, std::set<std::string>& names, std::set<std::string>& values) {
  if (node.type() == pugi::node_element) names.insert(node.name());
  for (const pugi::xml_attribute attribute : node.attributes()) {
    names.insert(attribute.name());
    values.insert(xml_escaped(attribute.value()));
  }
  for (const pugi::xml_node child : node.children()) collect(child, names, values);
}

bool is_xml(const std::string& text) { return text.starts_with('<'); }

pugi::xml_document xml_of(const std::string& text) {
  pugi::xml_document document;
  [[maybe_unused]] const auto parsed = document.load_buffer(text.data(), text.size());
  assert(parsed && "the good document is XML");
  return document;
}

}  // namespace

unsigned RandomBytes::below(unsigned count) {
  if (bytes_.empty()) return 0;
  const auto byte = static_cast<std::uint8_t>(bytes_.front());
  bytes_.remove_prefix(1);
  return byte % count;
}

std::size_t RandomBytes::index(std::size_t count) {
  const std::size_t high = below(255);
  return (high * 255 + below(255)) % count;
}

Grammar::Grammar(std::string good) : good_(std::move(good)) {
  std::set<std::string> names, values;
  if (is_xml(good_)) {
    names.insert(kJsonNamesOfElements.begin(), kJsonNamesOfElements.end());
    collect(xml_of(good_).document_element(), names, values);
  } else {
    collect(ordered_json::parse(good_), names, values);
  }
  names_.assign(names.begin(), names.end());
  values_.assign(values.begin(), values.end());
}

std::string Grammar::document(RandomBytes& choices) const {
  std::string text;
  if (is_xml(good_)) {
    XmlWriter writer(names_, values_, choices);
    writer.write(xml_of(good_).document_element());
    text = writer.take();
  } else {
    JsonWriter writer(names_, values_, choices);
    writer.write(ordered_json::parse(good_));
    text = writer.take();
  }
  switch (choices.below(32)) {
    case 1:
      text.resize(choices.index(text.size() + 1));
      break;
    case 2:
      text += std::string(1, '\0') + "x";
      break;
    case 3:
      text += text;
      break;
    default:
      break;
  }
  return text;
}

std::string Grammar::lines(RandomBytes& choices) const {
  std::string text;
  for (unsigned i = choices.below(6) + 1; i > 0; --i) text += document(choices) + "\n";
  return text;
}

Grammar grammar_of_seed(const std::string& name) {
  std::ifstream file(source_path("tests/fuzz/seeds/") + name, std::ios::binary);
  assert(file && "the seed is there");
  return Grammar(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace talus
