#include "property_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace talus {
namespace {

template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* const last = text.data() + text.size();
  const auto [end, problem] = std::from_chars(text.data(), last, number);
  return problem == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string_view label_of(PropertyKind kind) {
  constexpr std::array<std::string_view, kPropertyKinds> kLabels = {"text", "whole number", "number",
                                                                    "yes or no"};
  return kLabels[static_cast<std::size_t>(kind)];
}

PropertyKind kind_of(const Json& value) {
  if (value.is_boolean()) return PropertyKind::yes_or_no;
  if (value.is_number_integer()) return PropertyKind::whole_number;
  return value.is_number() ? PropertyKind::number : PropertyKind::text;
}

Json properties_in(const std::string& text) {
  Json json = text.empty() ? Json::object() : Json::parse(text, nullptr, false);
  return json.is_object() ? json : Json::object();
}

std::string text_of_properties(const Json& properties) {
  return properties.empty() ? "" : properties.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string with_property(const std::string& properties, const PropertyChange& change) {
  Json all = properties_in(properties);
  if (change.value)
    all[change.name] = *change.value;
  else
    all.erase(change.name);
  return text_of_properties(all);
}

std::string text_of_value(const Json& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Json> value_of_text(const std::string& text, PropertyKind kind) {
  switch (kind) {
    case PropertyKind::text:
      return Json(text);
    case PropertyKind::yes_or_no:
      if (text != "true" && text != "false") return std::nullopt;
      return Json(text == "true");
    case PropertyKind::whole_number: {
      const auto number = number_of<std::int64_t>(text);
      return number ? std::optional(Json(*number)) : std::nullopt;
    }
    case PropertyKind::number: {
      const auto number = number_of<double>(text);
      return number && std::isfinite(*number) ? std::optional(Json(*number)) : std::nullopt;
    }
  }
  return std::nullopt;
}

Json in_kind(const Json& value, PropertyKind kind) {
  if (kind_of(value) == kind) return value;
  if (kind == PropertyKind::whole_number && value.is_number_float()) {
    constexpr double kMax = 9e15;  // whole numbers up to there are exact
    const double whole = std::trunc(value.get<double>());
    return std::abs(whole) <= kMax ? Json(static_cast<std::int64_t>(whole)) : Json(0);
  }
  if (kind == PropertyKind::number && value.is_number_integer()) return Json(value.get<double>());
  if (const auto same = value_of_text(text_of_value(value), kind)) return *same;
  return kind == PropertyKind::yes_or_no ? Json(false) : kind == PropertyKind::number ? Json(0.0) : Json(0);
}

}  // namespace talus
