// The overlays that can be drawn over the play view. Each is a row with its functions, in the file that draws
// it.
#pragma once

#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

#include <talus/collision/geometry.h>

namespace talus {

struct Body;
struct ContactRecord;
struct Level;
struct OverlaySource;
struct SlopeProbe;
class OverlayPen;

// Which of its two colours an overlay has.
enum class OverlayPalette { standard, colour_blind };

// What an overlay is about.
enum class OverlayGroup { body, contact, ground, path };
struct OverlayGroupInfo {
  std::string_view key;    // "contact"
  std::string_view label;  // on its button
  std::string_view help;   // a sentence
};
// By OverlayGroup.
inline constexpr OverlayGroupInfo kOverlayGroups[] = {
    {"body", "Body", "Overlays that show how bodies are and move."},
    {"contact", "Contact", "Overlays that show what bodies met in the last step."},
    {"ground", "Ground", "Overlays that show the ground, and where it is wrong."},
    {"path", "Path", "Overlays that show where bodies went."}};

struct Overlay {
  std::string_view key;    // on the command line, in settings, and in its command's id: "floor_height"
  std::string_view label;  // on screen: "floor height"
  std::string_view help;   // what it shows, one sentence
  OverlayGroup group = OverlayGroup::body;
  std::uint32_t color = 0xffffff;  // 0xRRGGBB, the same in canvas, legend and tables; readable on dark ground
  std::uint32_t safe_color = 0xffffff;  // in the palette for colour-blind people
  char digit = 0;                       // '0' to '9': Alt and this digit switch the overlay; 0: no key does
  bool shift = false;                   // the key needs Shift too
  bool is_default = false;              // shown until the user chooses other overlays

  // What the drawing needs.
  bool needs_ground = false;  // OverlaySource::ground; it is compiled for the overlay if the solver has none
  bool needs_reach = false;   // OverlaySource::reach; `talus shot` searches it then
  bool needs_proof = false;   // OverlaySource::proof; `talus shot` proves the level then
  bool (*applies)(const Level&) = nullptr;  // false: the legend leaves it out; null: always true
  // A sentence that says why nothing of it is drawn for a level; "" if it is drawn. Null: always "".
  std::string_view (*why_nothing)(const Level&) = nullptr;
  bool near_only = false;  // left out at low zoom, where there would be millions of lines

  // How it is drawn.
  int layer = 0;                   // below 0: before what is drawn of each body, the lowest first
  bool is_faint = false;           // thin and without a rim, so that it does not hide the thing that it marks
  bool covers_much = false;        // labels may lie on its lines, as there would be no room otherwise
  bool is_short_from_far = false;  // its lines are shorter at low zoom, so that they do not hide bodies
  int label_rank = 3;              // 1 to 3: labels of a smaller rank find room first
  bool labels_above = false;       // labels go above their point if possible
  bool labels_outside = false;     // labels of points inside their body are left out

  // These draw it with a pen of its colour; null: the overlay has no such part. The overlay of shapes has
  // none, as the canvas draws it.
  void (*draw)(const OverlaySource&, OverlayPen&) = nullptr;
  void (*draw_body)(const OverlaySource&, const Body&, OverlayPen&) = nullptr;
  void (*draw_contact)(const OverlaySource&, const ContactRecord&, const Body&, OverlayPen&) = nullptr;
  void (*draw_probe)(const OverlaySource&, const SlopeProbe&, const Body&, OverlayPen&) = nullptr;
  void (*draw_swatch)(OverlayPen&) = nullptr;  // draws a sample for the legend in 8 by 8 px from {0, 0}
};

// All overlays of overlay_list.cpp, in the order of the switches and the legend.
std::span<const Overlay* const> all_overlays();
// What why_nothing says; "" if it says nothing.
std::string_view why_nothing(const Overlay& overlay, const Level& level);
std::uint32_t overlay_color(const Overlay& overlay, OverlayPalette palette);
// A lighter one for its labels, as letters are thin.
std::uint32_t overlay_text_color(const Overlay& overlay, OverlayPalette palette);
const Overlay* find_overlay(std::string_view key);  // null: there is none

// Overlays that other code names.
namespace overlay {
extern const Overlay boxes, normals, touch_points, impulses, velocity, slope_delta, floor_height,
    tested_tiles, answer, outline, removed_edges, one_way, swept_path, trails, penetration, shapes, reach,
    findings, conveyors;
}

// Overlays that answer one question together.
struct OverlayPreset {
  std::string_view key;    // in its command's id: "article"
  std::string_view label;  // on screen
  std::string_view help;   // a sentence
  std::span<const Overlay* const> overlays;
};
std::span<const OverlayPreset> overlay_presets();

class OverlaySet {
 public:
  static constexpr std::size_t kMax = 64;
  static OverlaySet all() { return OverlaySet(~0ull); }
  OverlaySet() = default;
  // The overlay must be one of all_overlays() (asserted).
  bool has(const Overlay& overlay) const { return bits_[place_of(overlay)]; }
  void set(const Overlay& overlay, bool on) { bits_[place_of(overlay)] = on; }
  bool empty() const { return bits_.none(); }
  // Whether the set has an overlay with such a member: any(&Overlay::needs_reach).
  bool any(bool Overlay::*member) const;
  friend bool operator==(const OverlaySet&, const OverlaySet&) = default;

 private:
  explicit OverlaySet(unsigned long long bits) : bits_(bits) {}
  static std::size_t place_of(const Overlay& overlay);
  std::bitset<kMax> bits_;
};

}  // namespace talus
