// KnownPlaces: where the files of a level led when they were opened or saved, so that a link which another
// program puts in the place of one is not followed unasked.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace talus {

class KnownPlaces {
 public:
  // The files of another level follow.
  void forget() { places_.clear(); }
  // Notes where these files lead now, unless that is known already.
  void note(const std::vector<std::string>& files);
  // The user has allowed a file to lead to this place, from elsewhere().
  void allow(const std::string& file, const std::string& place) { places_[file] = place; }
  // Where a file leads now; empty if it leads to where it did, or if it was never noted.
  std::string elsewhere(const std::string& file) const;

 private:
  std::map<std::string, std::string> places_;  // as real_path() gives them, by the path of the file
};

}  // namespace talus
