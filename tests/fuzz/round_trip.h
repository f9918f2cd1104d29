// What every format promises for every input: a level or one clear sentence, and no loss when it is written
// and read again.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include <talus/formats/format.h>
#include "document_checks.h"

namespace talus {

// Ends the program if the condition is false, in every build, unlike assert.
inline void require(bool condition) {
  if (!condition) std::abort();
}

// Prints the broken promise before it ends the program.
inline void require(const Checked& checked) {
  if (!checked.problem.empty()) std::cerr << checked.problem << std::endl;
  require(checked.problem.empty());
}

inline void require_clear(const FormatError& error) { require(checked_error(error)); }

// The native form keeps the whole level, and writing it again gives the same text.
inline void require_native_round_trip(const Level& level) { require(checked_level(level)); }

// An edit of a cart survives reading the cart again, and the other form of the cart keeps it too.
inline void require_edit_survives(Level level, const FormatContext& context) {
  level.map.set({5, 7}, static_cast<TileNumber>((level.map.tile_at({5, 7}) ^ 0x1f) % level.tile_count()));
  level.sheet(SheetId::tiles).flags[3] ^= 5;
  level.palette[2].r |= 1;  // not black, as an all-black palette counts as missing
  for (const char* id : {"tic", "tic-text"}) {
    const Format& format = *find_format(id);
    const auto written = format.write(level, context);
    if (!written) {  // no text project can hold this code
      require_clear(written.error());
      continue;
    }
    auto again = format.read(written->bytes, context);
    require(again.has_value());
    again->cart = level.cart;
    require(*again == level);
  }
}

// A cart keeps its bytes, and its level survives the other forms.
inline void require_cart_round_trip(const Format& format, std::string_view bytes,
                                    const FormatContext& context) {
  const auto level = format.read(bytes, context);
  if (!level) return require_clear(level.error());
  const auto written = format.write(*level, context);
  require(written && written->bytes == bytes);
  require_native_round_trip(*level);
  require_edit_survives(*level, context);
}

}  // namespace talus
