// The "cart" of a native level: the file that the level came from, stored so that every byte comes back.
//
//   "kind"     "tic" or "text".
//   "chunks"   tic: the chunks in order. "chunk": its name, or its number 0..31; "bank": 0..7 (0);
//              "reserved": last byte of its header (0); and its bytes: "code", lines of text, or "data",
//              rows of hexadecimal digits, or "level" for the bytes of the level's own section. Default: no
//              bytes.
//   "comment"  text: the comment prefix, "--".
//   "lines"    text: the lines of the file; {"level": "MAP"} stands for the rows of the level's own map.
//   "data"     text that is not UTF-8: rows of hexadecimal digits instead of "lines".
//
// The level's edits are put into the cart when it is written here, as if the cart itself were saved. So
// nothing is stored twice, and a changed row of the map is one changed line.
#pragma once

#include <memory>

#include "../text/json_text.h"

namespace talus {

// Sets the members of `cart`, an object. The level must have a cart (asserted).
void put_cart(const Level& level, Json& cart);

// Takes out the members named above. An error has its place by key; one about the cart file has "key cart".
FormatResult<std::shared_ptr<const CartOrigin>> take_cart(Json& cart, const Level& level);

}  // namespace talus
