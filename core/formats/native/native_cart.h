// The "cart" of a native level: the file that the level came from, such that every byte of it comes back.
//
//   "kind"     "tic" or "text".
//   "chunks"   tic: the chunks in order. "chunk": its name, or its number 0..31; "bank": 0..7 (0);
//              "reserved": last byte of its header (0); and its bytes: "code", lines of text; or "data",
//              rows of hexadecimal digits, or "level" for the bytes that the level's own section has.
//              Default: no bytes.
//   "comment"  text: the comment prefix, "--".
//   "lines"    text: the file's lines; {"level": "MAP"} stands for the rows that the level's own map has.
//   "data"     text that is no UTF-8: rows of hexadecimal digits in place of "lines".
//
// The level's edits are put into the cart when it is written here, as they would be on saving the cart
// itself, so that nothing is stored twice and a changed row of the map is one changed line.
#pragma once

#include <memory>

#include "../text/json_text.h"

namespace talus {

// Sets the members of `cart`, an object. The level must have a cart (asserted).
void put_cart(const Level& level, Json& cart);

// Takes out the members named above; an error is placed by key, the file's own by "key cart".
FormatResult<std::shared_ptr<const CartOrigin>> take_cart(Json& cart, const Level& level);

}  // namespace talus
