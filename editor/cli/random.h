// Random numbers that are the same on every machine, unlike those of the standard's distributions.
#pragma once

#include <cstdint>

namespace talus {

// SplitMix64 by Sebastiano Vigna.
inline std::uint64_t next_random(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// Evenly in [low, high).
inline double next_between(std::uint64_t& state, double low, double high) {
  return low + (high - low) * (static_cast<double>(next_random(state) >> 11) * 0x1p-53);
}

}  // namespace talus
