// The layers of objects that Talus wrote into a map, with the numbers that Tiled rounds.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tiled_map.h"

namespace talus {

class TiledBaseObjects {
 public:
  // layers: of the level when the map was written, which must outlive this.
  void set(const std::vector<ObjectLayer>& layers);
  // Chooses the layer that was written as this one, if there is one. Each is chosen once.
  void choose(const TiledLayer& layer);
  bool has_chosen() const { return chosen_ != nullptr; }
  // Gives a layer what maps of Tiled do not hold. tile_layers: how many layers of tiles the map has.
  void complete(ObjectLayer& layer, int tile_layers) const;
  // The object of the chosen layer that was written as this one; null if there is none.
  const MapObject* like(const TiledObject& object) const;

 private:
  const std::vector<ObjectLayer>* layers_ = nullptr;
  std::vector<bool> is_taken_;
  const ObjectLayer* chosen_ = nullptr;
  std::vector<std::pair<TiledObject, const MapObject*>> by_x_;  // of the chosen one
};

// Gives an object what its file has rounded. base: as it was written.
void take_exact(const MapObject& base, MapObject& object);

// Whether a thing has the name that Talus wrote, which in XML may lack characters of the true one.
bool is_name_of(const std::string& written, const std::string& name);

}  // namespace talus
