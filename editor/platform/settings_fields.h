// Settings as tables: one row a field, with its key in the file, its default, its range, and where it is
// kept.
//
//   const Fields<Layout> fields = {number("left", &Layout::left, 0.2, 0.05, 0.95), ...};
//   Layout layout;
//   read_fields(fields, json, layout);                // what the object lacks, or has wrong, gets its
//   default json = written_fields(fields, layout);
#pragma once

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace talus {

template <class Owner>
struct Field {
  const char* key;
  nlohmann::json standard;                                 // the default, as in a file
  std::function<bool(const nlohmann::json&)> accepts;      // whether a value of a file counts
  std::function<void(Owner&, const nlohmann::json&)> put;  // of an accepted value or the default
  std::function<nlohmann::json(const Owner&)> get;
};
template <class Owner>
using Fields = std::vector<Field<Owner>>;

// object: a JSON object. A field that it does not have, or whose value does not count, gets its default.
template <class Owner>
void read_fields(const Fields<Owner>& fields, const nlohmann::json& object, Owner& owner) {
  for (const Field<Owner>& field : fields) {
    const auto it = object.find(field.key);
    const bool counts = it != object.end() && field.accepts(*it);
    field.put(owner, counts ? *it : field.standard);
  }
}

template <class Owner>
nlohmann::json written_fields(const Fields<Owner>& fields, const Owner& owner) {
  nlohmann::json object = nlohmann::json::object();
  for (const Field<Owner>& field : fields) object[field.key] = field.get(owner);
  return object;
}

// Kinds of fields. `member`: a pointer to the owner's member. A number outside of min..max does not count.
template <class Owner, class T>
Field<Owner> number(const char* key, T Owner::*member, std::type_identity_t<T> standard, double min,
                    double max) {
  return {key, standard,
          [=](const nlohmann::json& v) {
            return v.is_number() && v.get<double>() >= min && v.get<double>() <= max;
          },
          [=](Owner& owner, const nlohmann::json& v) { owner.*member = static_cast<T>(v.get<double>()); },
          [=](const Owner& owner) { return nlohmann::json(owner.*member); }};
}

template <class Owner>
Field<Owner> toggle(const char* key, bool Owner::*member, bool standard) {
  return {key, standard, [](const nlohmann::json& v) { return v.is_boolean(); },
          [=](Owner& owner, const nlohmann::json& v) { owner.*member = v.get<bool>(); },
          [=](const Owner& owner) { return nlohmann::json(owner.*member); }};
}

// A value of an enum by its name; `names`: in the enum's order.
template <class Owner, class Enum>
Field<Owner> choice(const char* key, Enum Owner::*member, Enum standard, std::vector<std::string> names) {
  const auto place = [names](const nlohmann::json& v) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), v) - names.begin());
  };
  return {key, names[static_cast<std::size_t>(standard)],
          [=](const nlohmann::json& v) { return place(v) < names.size(); },
          [=](Owner& owner, const nlohmann::json& v) { owner.*member = static_cast<Enum>(place(v)); },
          [=](const Owner& owner) { return nlohmann::json(names[static_cast<std::size_t>(owner.*member)]); }};
}

template <class Owner>
Field<Owner> text(const char* key, std::string Owner::*member) {
  return {key, "", [](const nlohmann::json& v) { return v.is_string(); },
          [=](Owner& owner, const nlohmann::json& v) { owner.*member = v.get<std::string>(); },
          [=](const Owner& owner) { return nlohmann::json(owner.*member); }};
}

// A list of texts, at first empty. Of more than `most` the first ones count, and what is no text is left out.
template <class Owner>
Field<Owner> texts(const char* key, std::vector<std::string> Owner::*member, std::size_t most) {
  return {key, nlohmann::json::array(), [](const nlohmann::json& v) { return v.is_array(); },
          [=](Owner& owner, const nlohmann::json& list) {
            (owner.*member).clear();
            for (const nlohmann::json& v : list)
              if (v.is_string() && (owner.*member).size() < most)
                (owner.*member).push_back(v.get<std::string>());
          },
          [=](const Owner& owner) { return nlohmann::json(owner.*member); }};
}

// An object with fields of its own, each with its own default.
template <class Owner, class Part>
Field<Owner> object(const char* key, Part Owner::*member, Fields<Part> fields) {
  return {key, nlohmann::json::object(), [](const nlohmann::json& v) { return v.is_object(); },
          [=](Owner& owner, const nlohmann::json& v) { read_fields(fields, v, owner.*member); },
          [=](const Owner& owner) { return written_fields(fields, owner.*member); }};
}

// A field of a part that the file keeps beside the owner's own fields.
template <class Owner, class Part>
Field<Owner> of_part(Part Owner::*part, const Field<Part>& field) {
  return {field.key, field.standard, field.accepts,
          [=](Owner& owner, const nlohmann::json& v) { field.put(owner.*part, v); },
          [=](const Owner& owner) { return field.get(owner.*part); }};
}

// A list of objects, at first empty, at most `most`; those that lack an accepted `needed` are left out.
template <class Owner, class Part>
Field<Owner> objects(const char* key, std::vector<Part> Owner::*member, Fields<Part> fields,
                     const char* needed, std::size_t most) {
  const auto is_part = [fields, needed](const nlohmann::json& v) {
    return v.is_object() && v.contains(needed) &&
           std::any_of(fields.begin(), fields.end(), [&](const Field<Part>& f) {
             return f.key == std::string(needed) && f.accepts(v[needed]);
           });
  };
  return {key, nlohmann::json::array(), [](const nlohmann::json& v) { return v.is_array(); },
          [=](Owner& owner, const nlohmann::json& list) {
            (owner.*member).clear();
            for (const nlohmann::json& v : list)
              if (is_part(v) && (owner.*member).size() < most)
                read_fields(fields, v, (owner.*member).emplace_back());
          },
          [=](const Owner& owner) {
            nlohmann::json list = nlohmann::json::array();
            for (const Part& part : owner.*member) list.push_back(written_fields(fields, part));
            return list;
          }};
}

}  // namespace talus
