#include "known_places.h"

#include "formats/files/real_path.h"

namespace talus {

void KnownPlaces::note(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (file.empty() || places_.contains(file)) continue;
    if (const auto place = real_path(file)) places_[file] = *place;
  }
}

std::string KnownPlaces::elsewhere(const std::string& file) const {
  const auto known = places_.find(file);
  const auto now = known == places_.end() ? FormatResult<std::string>() : real_path(file);
  return known == places_.end() || !now || *now == known->second ? std::string() : *now;
}

}  // namespace talus
