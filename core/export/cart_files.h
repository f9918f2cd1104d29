// Carts as files of an export: the cart, and its companion with what a cart cannot hold.
#pragma once

#include "exporter.h"

namespace talus {

// cart: what the cart is written from; its code may differ from that of the request's level. The companion
// has what the request's level has beyond it. For the output "-" there is no companion, and `dropped` says
// so.
FormatResult<Exported> tic_files(const ExportRequest& request, const Level& cart);
// Returns an error if the name says another language than the code.
FormatResult<Exported> tic_text_files(const ExportRequest& request, const Level& cart);

}  // namespace talus
