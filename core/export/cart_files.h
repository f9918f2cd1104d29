// Carts as the files of an export: the cart, and what it cannot hold in its companion beside it.
#pragma once

#include "exporter.h"

namespace talus {

// cart: what the cart is written of, which may have another code than the request's level. The companion has
// what the request's level has more. Without a file beside, for the name "-", `dropped` says so.
FormatResult<Exported> tic_files(const ExportRequest& request, const Level& cart);
// An error when the name says another language than the code.
FormatResult<Exported> tic_text_files(const ExportRequest& request, const Level& cart);

}  // namespace talus
