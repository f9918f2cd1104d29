// Goes over the text of one element at a time.
#include "xml_places.h"

#include "xml_text.h"

namespace talus {
namespace {

// Behind the tag that begins at `at`.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return at + 1;
  }
  return text.size();
}

// Behind the mark, searched from `at`.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t at) {
  const std::size_t found = text.find(mark, at);
  return found == text.npos ? text.size() : found + mark.size();
}

// The place of the closing tag of an element whose content begins at `at`.
std::size_t closing_tag(std::string_view text, std::size_t at) {
  int depth = 0;  // of elements that are open in the content
  while ((at = text.find('<', at)) < text.size()) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(text, "-->", at + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(text, "]]>", at);
    } else if (rest.starts_with("<?")) {
      at = behind(text, "?>", at);
    } else if (rest.starts_with("</")) {
      if (depth-- == 0) return at;
      at = end_of_tag(text, at);
    } else {
      at = end_of_tag(text, at);
      if (text[at - 2] != '/') ++depth;
    }
  }
  return text.size();
}

bool is_blank_of_xml(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

TextSpan XmlPlaces::open_tag(const pugi::xml_node& element) const {
  const auto begin = static_cast<std::size_t>(element.offset_debug()) - 1;  // that of its name
  return {begin, end_of_tag(text_, begin)};
}

bool XmlPlaces::has_inside(const pugi::xml_node& element) const {
  return text_[open_tag(element).end - 2] != '/';
}

TextSpan XmlPlaces::inside(const pugi::xml_node& element) const {
  const std::size_t begin = open_tag(element).end;
  return {begin, has_inside(element) ? closing_tag(text_, begin) : begin};
}

TextSpan XmlPlaces::whole(const pugi::xml_node& element) const {
  const std::size_t end = inside(element).end;
  return {open_tag(element).begin, has_inside(element) ? end_of_tag(text_, end) : end};
}

std::optional<TextSpan> XmlPlaces::attribute(const pugi::xml_node& element, std::string_view name) const {
  const TextSpan tag = open_tag(element);
  std::size_t at = text_.find_first_of(" \t\r\n/>", tag.begin);
  while (at < tag.end) {
    while (at < tag.end && is_blank_of_xml(text_[at])) ++at;
    const std::size_t equal = text_.find('=', at);
    if (equal >= tag.end) break;
    std::size_t name_end = equal;
    while (name_end > at && is_blank_of_xml(text_[name_end - 1])) --name_end;
    const std::size_t quote = text_.find_first_of("\"'", equal);
    const std::size_t end = quote >= tag.end ? tag.end : text_.find(text_[quote], quote + 1);
    if (end >= tag.end) break;
    if (text_.substr(at, name_end - at) == name) return TextSpan{quote + 1, end};
    at = end + 1;
  }
  return std::nullopt;
}

std::optional<TextSpan> XmlPlaces::whole_attribute(const pugi::xml_node& element,
                                                   std::string_view name) const {
  const auto value = attribute(element, name);
  if (!value) return std::nullopt;
  std::size_t begin = text_.rfind(name, text_.rfind('=', value->begin));
  while (is_blank_of_xml(text_[begin - 1])) --begin;
  return TextSpan{begin, value->end + 1};
}

std::size_t XmlPlaces::end_of_attributes(const pugi::xml_node& element) const {
  std::size_t end = open_tag(element).end - (has_inside(element) ? 1 : 2);
  while (is_blank_of_xml(text_[end - 1])) --end;
  return end;
}

std::string XmlPlaces::break_before(const pugi::xml_node& element) const {
  const std::size_t end = open_tag(element).begin;
  std::size_t begin = end;
  while (begin > 0 && (text_[begin - 1] == ' ' || text_[begin - 1] == '\t')) --begin;
  if (begin == 0 || text_[begin - 1] != '\n') return "";
  --begin;
  if (begin > 0 && text_[begin - 1] == '\r') --begin;
  return std::string(text_.substr(begin, end - begin));
}

std::string xml_attribute_text(std::string_view text) {
  std::string result;
  for (const char c : xml_text(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&apos;";
        break;
      case '\n':
        result += "&#10;";
        break;
      case '\r':
        result += "&#13;";
        break;
      case '\t':
        result += "&#9;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

void set_xml_attribute(const XmlPlaces& places, const pugi::xml_node& element, std::string_view name,
                       std::string_view value, TextEdits& edits) {
  std::string text = xml_attribute_text(value);
  if (const auto known = places.attribute(element, name)) {
    if (element.attribute(std::string(name).c_str()).value() != value) edits.replace(*known, std::move(text));
    return;
  }
  edits.insert(places.end_of_attributes(element), " " + std::string(name) + "=\"" + text + "\"");
}

void remove_xml_attribute(const XmlPlaces& places, const pugi::xml_node& element, std::string_view name,
                          TextEdits& edits) {
  if (const auto known = places.whole_attribute(element, name)) edits.replace(*known, "");
}

void append_xml_inside(const XmlPlaces& places, const pugi::xml_node& element, std::string text,
                       TextEdits& edits) {
  if (places.has_inside(element)) return edits.insert(places.inside(element).end, std::move(text));
  const std::size_t end = places.open_tag(element).end;
  edits.replace({end - 2, end}, ">" + std::move(text) + "</" + element.name() + ">");
}

}  // namespace talus
