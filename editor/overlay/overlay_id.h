// The overlays that can be drawn over the play view.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

namespace talus {

enum class OverlayId {
  boxes,
  normals,
  touch_points,
  velocity,
  slope_delta,
  floor_height,
  tested_tiles,
  answer,
  outline,
  removed_edges,
  one_way,
  swept_path,
  trails,
  penetration,
  shapes,
  reach
};
inline constexpr int kOverlayCount = 16;

struct OverlayInfo {
  OverlayId id;
  std::string_view key;      // on the command line: "floor_height"
  std::string_view label;    // on screen: "floor height"
  std::string_view help;     // what it shows, one sentence
  std::uint32_t color;       // 0xRRGGBB, the same in canvas, legend and tables
  std::uint32_t safe_color;  // in the palette for colour-blind eyes
};
// Which of its colours an overlay is drawn in.
enum class OverlayPalette { standard, colour_blind };
const std::array<OverlayInfo, kOverlayCount>& overlay_infos();
std::uint32_t overlay_color(OverlayId id, OverlayPalette palette);
std::optional<OverlayId> find_overlay(std::string_view key);

class OverlaySet {
 public:
  static OverlaySet all() { return OverlaySet(~0ull); }
  OverlaySet() = default;
  bool has(OverlayId id) const { return bits_[static_cast<std::size_t>(id)]; }
  void set(OverlayId id, bool on) { bits_[static_cast<std::size_t>(id)] = on; }
  bool empty() const { return bits_.none(); }
  friend bool operator==(const OverlaySet&, const OverlaySet&) = default;

 private:
  explicit OverlaySet(unsigned long long bits) : bits_(bits) {}
  std::bitset<kOverlayCount> bits_;
};

}  // namespace talus
