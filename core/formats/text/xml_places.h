// Where the parts of an element are in the text that pugixml has read without changing it.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "text_edits.h"

namespace talus {

class XmlPlaces {
 public:
  // text: the one that the nodes were read from, which is well-formed. It must live as long as this.
  explicit XmlPlaces(std::string_view text) : text_(text) {}

  TextSpan open_tag(const pugi::xml_node& element) const;  // with its brackets; of "<a/>" the whole
  bool has_inside(const pugi::xml_node& element) const;    // false for "<a/>"
  TextSpan inside(const pugi::xml_node& element) const;    // between the tags; of "<a/>" nothing behind it
  TextSpan whole(const pugi::xml_node& element) const;     // with its tags
  // The value of an attribute, without quotes.
  std::optional<TextSpan> attribute(const pugi::xml_node& element, std::string_view name) const;
  // An attribute with its name, its quotes and the blanks before it.
  std::optional<TextSpan> whole_attribute(const pugi::xml_node& element, std::string_view name) const;
  std::size_t end_of_attributes(const pugi::xml_node& element) const;  // where another one may be added
  // The blanks before the element, from the line break on: "\n  ". Empty if it does not begin a line.
  std::string break_before(const pugi::xml_node& element) const;

 private:
  std::string_view text_;
};

// A value for an attribute: with references for marks and line breaks.
std::string xml_attribute_text(std::string_view text);

// Sets an attribute; a new one comes behind the others.
void set_xml_attribute(const XmlPlaces& places, const pugi::xml_node& element, std::string_view name,
                       std::string_view value, TextEdits& edits);
// Takes an attribute away, if there is one, with the blanks before it.
void remove_xml_attribute(const XmlPlaces& places, const pugi::xml_node& element, std::string_view name,
                          TextEdits& edits);
// Puts text before the closing tag, which "<a/>" gets.
void append_xml_inside(const XmlPlaces& places, const pugi::xml_node& element, std::string text,
                       TextEdits& edits);

}  // namespace talus
