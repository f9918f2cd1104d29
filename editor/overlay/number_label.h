// Numbers as the overlays and panels show them.
#pragma once

#include <string>

namespace talus {

std::string two_decimals(double value);  // "0.84"; never "-0.00"
// The same, but of what that would call 0.00 its first two digits: "9.5e-07". For differences.
std::string small_too(double value);
std::string no_decimals(double value);  // "92"
std::string one_decimal(double value);  // "-.4", "1", "0": for the parts of unit vectors
// When a contact was, as a fraction of the motion: "t 0.25". Of boxes that overlapped before it there is
// none.
std::string time_label(double ti, bool overlaps);
std::string all_digits(double value);  // the 17 digits that a double may need

}  // namespace talus
