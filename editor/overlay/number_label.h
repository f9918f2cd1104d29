// Numbers as the overlays and panels show them.
#pragma once

#include <string>

namespace talus {

std::string two_decimals(double value);  // "0.84"; never "-0.00"
// The same for differences: a number that would be "0.00" is given with its first two digits, such as
// "9.5e-07".
std::string small_too(double value);
std::string no_decimals(double value);  // "92"
std::string one_decimal(double value);  // "-.4", "1", "0": for the parts of unit vectors
// The time of a contact as a fraction of the motion: "t 0.25". Empty for boxes that overlapped before it.
std::string time_label(double ti, bool overlaps);
std::string all_digits(double value);  // up to the 17 digits that a double may need

}  // namespace talus
