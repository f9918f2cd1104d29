// Common icons are glyphs of a font; what no font has is a few strokes in a unit square.
#include "icons.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <iterator>

#include "shown_text.h"

namespace talus {
namespace {

class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 at, float size, ImU32 color)
      : list_(list), at_(at), size_(size), color_(color), width_(std::max(1.0f, size / 11)) {}

  ImVec2 point(ImVec2 p) const { return {at_.x + p.x * size_, at_.y + p.y * size_}; }
  void stroke(std::initializer_list<ImVec2> points, bool closed = false) const {
    for (ImVec2 p : points) list_.PathLineTo(point(p));
    list_.PathStroke(color_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
  }
  void solid(std::initializer_list<ImVec2> points) const {
    for (ImVec2 p : points) list_.PathLineTo(point(p));
    list_.PathFillConvex(color_);
  }
  void box(float x0, float y0, float x1, float y1) const {
    list_.AddRectFilled(point({x0, y0}), point({x1, y1}), color_);
  }
  void frame(float x0, float y0, float x1, float y1) const {
    stroke({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true);
  }
  void arc(ImVec2 centre, float radius, float from, float to) const {
    list_.PathArcTo(point(centre), radius * size_, from, to, 16);
    list_.PathStroke(color_, ImDrawFlags_None, width_);
  }

 private:
  ImDrawList& list_;
  ImVec2 at_;
  float size_;
  ImU32 color_;
  float width_;
};

void draw_tool_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::stamp:
      pen.box(.15f, .15f, .47f, .47f);
      pen.box(.53f, .53f, .85f, .85f);
      pen.frame(.56f, .15f, .85f, .44f);
      pen.frame(.15f, .56f, .44f, .85f);
      break;
    case Icon::fill:
      pen.stroke({{.42f, .15f}, {.8f, .5f}, {.45f, .85f}, {.1f, .5f}}, true);
      pen.solid({{.14f, .5f}, {.76f, .5f}, {.45f, .82f}});
      pen.solid({{.88f, .6f}, {.96f, .82f}, {.8f, .82f}});
      break;
    case Icon::body:
      pen.box(.28f, .12f, .72f, .66f);
      pen.stroke({{.14f, .82f}, {.86f, .82f}});
      break;
    case Icon::slope:
      pen.solid({{.1f, .84f}, {.9f, .3f}, {.9f, .84f}});
      break;
    case Icon::segment:
      pen.stroke({{.16f, .78f}, {.84f, .24f}});
      pen.box(.08f, .7f, .24f, .86f);
      pen.box(.76f, .16f, .92f, .32f);
      break;
    case Icon::curve:
      pen.arc({.5f, .72f}, .36f, 3.1416f, 6.2832f);
      pen.box(.06f, .66f, .22f, .82f);
      pen.box(.78f, .66f, .94f, .82f);
      break;
    case Icon::object:  // a box and a circle, one over the other
      pen.frame(.1f, .12f, .6f, .62f);
      pen.arc({.66f, .66f}, .26f, 0, 6.2832f);
      break;
    case Icon::ground:
      pen.solid({{.08f, .86f}, {.08f, .66f}, {.5f, .66f}, {.5f, .86f}});
      pen.solid({{.44f, .86f}, {.44f, .66f}, {.66f, .36f}, {.92f, .36f}, {.92f, .86f}});
      break;
    default:  // line
      pen.stroke({{.14f, .86f}, {.86f, .14f}});
      break;
  }
}

void draw_picture_icon(const Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::select:
      for (float f : {.12f, .44f, .76f}) {
        for (float side : {.14f, .86f}) {
          pen.stroke({{f, side}, {f + .14f, side}});
          pen.stroke({{side, f}, {side, f + .14f}});
        }
      }
      break;
    case Icon::neighbours:
      pen.box(.36f, .36f, .64f, .64f);
      for (float f : {.28f, .72f}) {
        pen.stroke({{f, .06f}, {f, .94f}});
        pen.stroke({{.06f, f}, {.94f, f}});
      }
      break;
    case Icon::flip_horizontal:
      pen.solid({{.42f, .2f}, {.42f, .8f}, {.1f, .8f}});
      pen.stroke({{.58f, .2f}, {.58f, .8f}, {.9f, .8f}}, true);
      break;
    case Icon::flip_vertical:
      pen.solid({{.2f, .42f}, {.8f, .42f}, {.8f, .1f}});
      pen.stroke({{.2f, .58f}, {.8f, .58f}, {.8f, .9f}}, true);
      break;
    default:  // borders
      pen.frame(.12f, .22f, .88f, .78f);
      pen.stroke({{.5f, .22f}, {.5f, .78f}});
      break;
  }
}

// A glyph of the icon font, with a text that replaces it if the font is missing.
struct Glyph {
  Icon icon;
  ImWchar code;  // in Fork Awesome
  const char* text;
};
constexpr Glyph kGlyphs[] = {
    {Icon::first_frame, 0xf049, "|<"}, {Icon::last_frame, 0xf050, ">|"}, {Icon::restart, 0xf021, "O"},
    {Icon::play, 0xf04b, ">"},         {Icon::pause, 0xf04c, "||"},      {Icon::step, 0xf051, "+1"},
    {Icon::step_back, 0xf048, "-1"},   {Icon::run_on, 0xf04e, ">>"},     {Icon::run_back, 0xf04a, "<<"},
    {Icon::split, 0xf0db, "[]"},       {Icon::pan, 0xf047, "<>"},        {Icon::rectangle, 0xf0c8, "R"},
    {Icon::erase, 0xf12d, "E"},        {Icon::pick, 0xf1fb, "?"},        {Icon::pencil, 0xf040, "P"},
    {Icon::frame, 0xf096, "F"},        {Icon::ellipse, 0xf1db, "O"},     {Icon::enlarge, 0xf065, "[+]"},
    {Icon::rotate, 0xf01e, "R"},       {Icon::clear, 0xf014, "C"},       {Icon::grid, 0xf00a, "#"},
    {Icon::minimap, 0xf278, "M"},      {Icon::dice, 0xf074, "~"},        {Icon::zoom_in, 0xf00e, "+"},
    {Icon::zoom_out, 0xf010, "-"},     {Icon::eye, 0xf06e, "o"},         {Icon::eye_closed, 0xf070, "-"},
    {Icon::lock, 0xf023, "L"},         {Icon::unlock, 0xf09c, "U"},      {Icon::plus, 0xf067, "+"},
    {Icon::copy, 0xf24d, "++"},        {Icon::arrow_up, 0xf062, "^"},    {Icon::arrow_down, 0xf063, "v"},
    {Icon::merge_down, 0xf103, "_"},   {Icon::follow, 0xf05b, "+"},      {Icon::close, 0xf00d, "x"},
    {Icon::folder, 0xf07b, "G"},       {Icon::hand, 0xf25a, "^"},        {Icon::more, 0xf142, ":"},
};

const Glyph* find_glyph(Icon icon) {
  const auto* found =
      std::find_if(std::begin(kGlyphs), std::end(kGlyphs), [&](const Glyph& g) { return g.icon == icon; });
  return found == std::end(kGlyphs) ? nullptr : found;
}

void draw_glyph(ImDrawList& list, const Glyph& glyph, ImVec2 middle, ImU32 color) {
  const ImFont& font = *ImGui::GetFont();
  const float size = ImGui::GetFontSize(), scale = size / font.FontSize;
  if (const ImFontGlyph* g = font.FindGlyphNoFallback(glyph.code)) {
    const ImVec2 at = {middle.x - (g->X0 + g->X1) / 2 * scale, middle.y - (g->Y0 + g->Y1) / 2 * scale};
    font.RenderChar(&list, size, {std::round(at.x), std::round(at.y)}, color, glyph.code);
    return;
  }
  const ImVec2 extent = ImGui::CalcTextSize(glyph.text);
  add_text(list, {std::round(middle.x - extent.x / 2), std::round(middle.y - extent.y / 2)}, color,
           glyph.text);
}

}  // namespace

void add_icon_font(ImFontAtlas& fonts, float scale) {
  constexpr const char* kFile = "/usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf";
  constexpr float kSize = 14;  // px at scale 1
  static constexpr ImWchar kRange[] = {0xf000, 0xf2ff, 0};
  std::error_code error;
  if (!std::filesystem::exists(kFile, error)) return;
  ImFontConfig config;
  config.MergeMode = true;
  config.OversampleH = 2;
  fonts.AddFontFromFileTTF(kFile, std::round(kSize * scale), &config, kRange);
}

void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color) {
  if (icon == Icon::none) return;
  if (const Glyph* glyph = find_glyph(icon))
    return draw_glyph(list, *glyph, {at.x + size / 2, at.y + size / 2}, color);
  const Pen pen(list, at, size, color);
  if (icon <= Icon::line) return draw_tool_icon(pen, icon);
  draw_picture_icon(pen, icon);
}

}  // namespace talus
