#include "level.h"

namespace talus {

bool operator==(const Level& a, const Level& b) {
  const bool same_cart = a.cart == b.cart || (a.cart && b.cart && *a.cart == *b.cart);
  return same_cart && a.sheets == b.sheets && a.palette == b.palette && a.flag_names == b.flag_names &&
         a.roles == b.roles && a.map == b.map && a.tuning == b.tuning && a.spawns == b.spawns &&
         a.extra == b.extra;
}

}  // namespace talus
