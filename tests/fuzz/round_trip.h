// What every format promises about every input: a level or one clear sentence, and nothing lost on the way
// back.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include <talus/formats/format.h>
#include "document_checks.h"

namespace talus {

// Unlike assert, there in every build.
inline void require(bool condition) {
  if (!condition) std::abort();
}

// Says what is wrong before it ends.
inline void require(const Checked& checked) {
  if (!checked.problem.empty()) std::cerr << checked.problem << std::endl;
  require(checked.problem.empty());
}

inline void require_clear(const FormatError& error) { require(checked_error(error)); }

// Through the native form the level comes back whole, and its text is settled.
inline void require_native_round_trip(const Level& level) { require(checked_level(level)); }

// An edit of a cart is there when the cart is read again, and the cart of another form takes it too.
inline void require_edit_survives(Level level, const FormatContext& context) {
  level.map.set({5, 7}, static_cast<std::uint8_t>(level.map.at({5, 7}) ^ 0x1f));
  level.sheet(SheetId::tiles).flags[3] ^= 5;
  level.palette[2].r |= 1;  // not black: an all-black palette is none
  for (const char* id : {"tic", "tic-text"}) {
    const Format& format = *find_format(id);
    const auto written = format.write(level, context);
    if (!written) {  // code that a text project cannot hold
      require_clear(written.error());
      continue;
    }
    auto again = format.read(written->bytes, context);
    require(again.has_value());
    again->cart = level.cart;
    require(*again == level);
  }
}

// A cart's bytes come back as they were, and its level survives the other forms.
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
