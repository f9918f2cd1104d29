// Finds overlays by key.
#include "overlay_table.h"

#include <algorithm>
#include <cassert>

namespace talus {

std::string_view why_nothing(const Overlay& overlay, const Level& level) {
  return overlay.why_nothing != nullptr ? overlay.why_nothing(level) : std::string_view();
}

std::uint32_t overlay_color(const Overlay& overlay, OverlayPalette palette) {
  return palette == OverlayPalette::standard ? overlay.color : overlay.safe_color;
}

std::uint32_t overlay_text_color(const Overlay& overlay, OverlayPalette palette) {
  const std::uint32_t color = overlay_color(overlay, palette);
  std::uint32_t text = 0;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t part = color >> shift & 0xff;
    text |= (part + (0xff - part) * 2 / 5) << shift;
  }
  return text;
}

const Overlay* find_overlay(std::string_view key) {
  const auto all = all_overlays();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Overlay* overlay) { return overlay->key == key; });
  return found == all.end() ? nullptr : *found;
}

bool OverlaySet::any(bool Overlay::*member) const {
  const auto all = all_overlays();
  return std::any_of(all.begin(), all.end(),
                     [&](const Overlay* overlay) { return overlay->*member && has(*overlay); });
}

std::size_t OverlaySet::place_of(const Overlay& overlay) {
  const auto all = all_overlays();
  const auto found = std::find(all.begin(), all.end(), &overlay);
  assert(found != all.end() && all.size() <= kMax);
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace talus
