#include <talus/level/flag_fields.h>

#include <algorithm>
#include <bit>

namespace talus {

int FlagPattern::lowest_flag() const { return std::countr_zero(mask); }

std::optional<std::string> problem_of(const FlagField& field) {
  if (field.bits < FlagField::kLeastBits || field.bits > FlagField::kMaxBits) return "must have 2 to 8 bits";
  if (field.first < 0 || field.last() >= kMaxFlags) return "reaches beyond flag 31";
  if (field.values.size() > static_cast<std::size_t>(field.value_count()))
    return "has more names than values: " + std::to_string(field.values.size()) + " for " +
           std::to_string(field.value_count());
  return {};
}

const FlagField* field_of_flag(std::span<const FlagField> fields, int flag) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FlagField& field) {
    return flag >= field.first && flag <= field.last();
  });
  return found == fields.end() ? nullptr : &*found;
}

std::optional<std::size_t> overlapping_field(std::span<const FlagField> fields) {
  FlagSet taken = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if ((taken & fields[i].mask()) != 0) return i;
    taken |= fields[i].mask();
  }
  return {};
}

int most_bits(std::span<const FlagField> others, int first) {
  int bits = 1;
  while (bits < FlagField::kMaxBits && first + bits < kMaxFlags &&
         field_of_flag(others, first + bits) == nullptr)
    ++bits;
  return bits;
}

}  // namespace talus
