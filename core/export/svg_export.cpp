// The map as a drawing: its picture, the outline of the ground, normals, one-way lines, curves, bodies.
#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include <talus/level/ground.h>
#include "../collision/outline_compiler.h"
#include "../formats/text/append_number.h"
#include "../formats/text/base64.h"
#include "../formats/text/xml_text.h"
#include "export_targets.h"
#include "ground_polygons.h"
#include "map_png.h"
#include "plain_data.h"

namespace talus {
namespace {

constexpr double kTickLength = 2;  // px, of a normal
constexpr int kSineParts = 4;      // cubics for a quarter wave: the error is 1e-4 of the amplitude

// The text of a path: "M1 2L3 4Z".
class SvgPath {
 public:
  SvgPath& operator()(const char* command, std::initializer_list<double> values = {}) {
    text_ += command;
    bool first = true;
    for (const double value : values) {
      if (!first) text_ += ' ';
      first = false;
      append_number(text_, value);
    }
    return *this;
  }
  SvgPath& move(Vec2 to) { return (*this)("M", {to.x, to.y}); }
  SvgPath& line(Vec2 to) { return (*this)("L", {to.x, to.y}); }
  void polyline(const std::vector<Vec2>& points) {
    move(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i]);
  }
  // A short line out of the ground, which is on the right when seen along `along`.
  void tick(Vec2 at, Vec2 along) {
    const double length = kTickLength / std::hypot(along.x, along.y);
    move(at)("l", {along.y * length + 0.0, 0.0 - along.x * length});  // + 0.0 avoids -0
  }
  void ticks(const std::vector<Vec2>& points, bool closed) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      const Vec2 from = points[i], to = points[(i + 1) % points.size()];
      tick((from + to) * 0.5, to - from);
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// The path of a curve from its left end on; exact, as far as SVG can be, except for sines.
class CurvePath {
 public:
  CurvePath(const Curve& curve, SvgPath& path, SvgPath& normals) : path_(path), normals_(normals) {
    const bool down = curve.faces == Curve::Faces::down;
    Curve upper = curve;
    upper.faces = Curve::Faces::up;  // each piece once
    outline_ = cut_curves({&upper, 1});
    const Piece<double>&first = outline_.pieces.front(), last = outline_.pieces.back();
    path_.move({first.x0, first.facing == Facing::left ? first.y1 : first.y0});
    to_ = {last.x1, last.facing == Facing::left ? last.y0 : last.y1};
    from_ = {first.x0, first.y0};
    std::visit([this](const auto& form) { put(form); }, curve.form);
    for (const Piece<double>& piece : outline_.pieces) {
      if (!down) put_normal(piece, 1);
      if (curve.faces != Curve::Faces::up) put_normal(piece, -1);
    }
  }

 private:
  void put(const Segment&) { path_.line(to_); }
  void put(const Polyline&) {
    for (const Piece<double>& p : outline_.pieces)
      path_.line(p.facing == Facing::left ? Vec2{p.x0, p.y0} : Vec2{p.x1, p.y1});
  }
  void put(const Arc& a) { path_("A", {a.radius, a.radius, 0, 0, a.upper ? 1.0 : 0.0, to_.x, to_.y}); }
  void put(const Parabola& p) { path_("Q", {(from_.x + to_.x) / 2, weld(p.control_y), to_.x, to_.y}); }
  void put(const Cubic& c) { put_cubic(from_, to_, c.from_slope, c.to_slope); }
  void put(const Sine&) {
    for (const Piece<double>& piece : outline_.pieces) {
      const CurveStretch<double>& stretch = outline_.stretches[piece.stretch - 1];
      Vec2 from{piece.x0, piece.y0};
      for (int part = 1; part <= kSineParts; ++part) {
        const double x = part == kSineParts ? piece.x1 : piece.x0 + (piece.x1 - piece.x0) * part / kSineParts;
        const Vec2 to{x, piece.y_at(x, outline_.stretches)};
        const auto t0 = stretch.tangent_at(from.x), t1 = stretch.tangent_at(to.x);
        put_cubic(from, to, t0.y / t0.x, t1.y / t1.x);
        from = to;
      }
    }
  }
  void put_cubic(Vec2 from, Vec2 to, double from_slope, double to_slope) {
    const double third = (to.x - from.x) / 3;
    path_("C",
          {from.x + third, from.y + from_slope * third, to.x - third, to.y - to_slope * third, to.x, to.y});
  }
  void put_normal(const Piece<double>& piece, double sign) {
    const Vec2 middle = Vec2{piece.x0 + piece.x1, piece.y0 + piece.y1} * 0.5;
    if (piece.is_wall()) return normals_.tick(middle, {0, piece.facing == Facing::left ? -sign : sign});
    Vec2 along{1, piece.slope};
    if (piece.stretch != 0) along = outline_.stretches[piece.stretch - 1].tangent_at(middle.x);
    normals_.tick({middle.x, piece.y_at(middle.x, outline_.stretches)}, along * sign);
  }

  SvgPath& path_;
  SvgPath& normals_;
  CurveOutline outline_;
  Vec2 from_, to_;
};

std::string number_text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

struct SvgAttribute {
  const char* name;
  std::string value;
};

pugi::xml_node add(pugi::xml_node parent, const char* name, std::initializer_list<SvgAttribute> attributes) {
  pugi::xml_node node = parent.append_child(name);
  for (const SvgAttribute& a : attributes) node.append_attribute(a.name) = a.value.c_str();
  return node;
}

pugi::xml_node add_root(pugi::xml_document& document, const Level& level, const std::string& png) {
  const std::string width = number_text_of(level.map.px_width());
  const std::string height = number_text_of(level.map.px_height());
  const auto root = add(document, "svg",
                        {{"xmlns", "http://www.w3.org/2000/svg"},
                         {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
                         {"width", width},
                         {"height", height},
                         {"viewBox", "0 0 " + width + " " + height}});
  add(root, "image",
      {{"width", width},
       {"height", height},
       {"style", "image-rendering:pixelated"},
       {"xlink:href", "data:image/png;base64," + encode_base64(png)}});
  return root;
}

void add_path(pugi::xml_node root, const char* id, const char* color, const SvgPath& path,
              std::initializer_list<SvgAttribute> more = {}) {
  if (path.text().empty()) return;
  auto node = add(root, "path", {{"id", id}, {"fill", "none"}, {"stroke", color}, {"stroke-width", "0.75"}});
  for (const SvgAttribute& a : more) {
    if (!node.attribute(a.name)) node.append_attribute(a.name);
    node.attribute(a.name) = a.value.c_str();
  }
  node.append_attribute("d") = path.text().c_str();
}

void add_spawns(pugi::xml_node root, const std::vector<Spawn>& spawns) {
  if (spawns.empty()) return;
  auto group = add(root, "g", {{"id", "spawns"}, {"fill", "none"}, {"stroke-width", "0.75"}});
  for (const Spawn& spawn : spawns) {
    auto box = add(group, "rect",
                   {{"class", std::string(traits_of(spawn.kind).word)},
                    {"x", number_text_of(spawn.position.x)},
                    {"y", number_text_of(spawn.position.y)},
                    {"width", number_text_of(spawn.size.x)},
                    {"height", number_text_of(spawn.size.y)},
                    {"stroke", std::string(traits_of(spawn.kind).svg_color)}});
    if (!spawn.name.empty()) box.append_child("title").text() = xml_text(spawn.name).c_str();
  }
}

}  // namespace

FormatResult<Exported> export_svg(const ExportRequest& request) {
  const Level& level = request.level;
  const FormatResult<std::string> png = map_png(level, request.progress.part(0, 0.7), kMaxPictureInside);
  if (!png) return tl::unexpected(png.error());
  if (!request.progress.at(0.7)) return Exported();
  pugi::xml_document document;
  const pugi::xml_node root = add_root(document, level, *png);

  TerrainSource ground = ground_of(level);
  ground.progress = request.progress.part(0.7, 0.85).function();
  SvgPath outline, one_way, curves, normals;
  const FormatResult<std::vector<GroundPolygon>> polygons = ground_polygons(ground);
  if (!polygons) return tl::unexpected(polygons.error());
  for (const GroundPolygon& polygon : *polygons) {
    outline.polyline(polygon.points);
    outline("Z");
    normals.ticks(polygon.points, true);
  }
  for (const PlainLine& line : plain_lines(level, request.progress.part(0.85, 0.95))) {
    if (line.is_curve) continue;
    one_way.polyline(line.points);
    normals.ticks(line.points, false);
  }
  for (const Curve& curve : ground.curves) CurvePath(curve, curves, normals);

  add_path(root, "ground", "#ffe040", outline, {{"fill", "#ffe040"}, {"fill-opacity", "0.2"}});
  add_path(root, "one-way", "#40ffff", one_way, {{"stroke-dasharray", "2 1"}});
  add_path(root, "curves", "#ff80ff", curves);
  add_path(root, "normals", "#ffffff", normals, {{"stroke-width", "0.5"}});
  add_spawns(root, level.spawns);
  std::ostringstream text;
  document.save(text, " ");
  return exported_file(text.str());
}

}  // namespace talus
