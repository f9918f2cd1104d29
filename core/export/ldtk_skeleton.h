// The objects of an LDtk project with every key that LDtk's schema requires: assets/templates/ldtk.json.
#pragma once

#include <string>

#include "exporter.h"
#include "plain_text.h"

namespace talus {

class LdtkSkeleton {
 public:
  explicit LdtkSkeleton(OrderedJson parts) : parts_(std::move(parts)) {}
  // A part, by its key in the asset, with these members instead of its own; its other members keep their
  // places.
  OrderedJson filled(const char* part, const OrderedJson& changes) const;

 private:
  OrderedJson parts_;
};

// An error when the asset cannot be read, or lacks a part that an export fills.
FormatResult<LdtkSkeleton> read_ldtk_skeleton(const ReadAsset& read_asset);

}  // namespace talus
