#include "hard_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "transform.h"

namespace talus {
namespace {

double y_at(const Segment& s, double x) {
  return s.from.y + (s.to.y - s.from.y) * (x - s.from.x) / (s.to.x - s.from.x);
}
double y_at(const Arc& a, double x) {
  const double u = x - a.center.x;
  const double height = std::sqrt(std::max(0.0, (a.radius - u) * (a.radius + u)));
  return a.upper ? a.center.y - height : a.center.y + height;
}
double y_at(const Sine& s, double x) {
  const double turns = (x - s.origin) / s.wavelength;
  return s.middle + s.amplitude * std::sin(2 * std::numbers::pi * (turns - std::round(turns)));
}

// The highest point of a part between two x, if it is not at one of them.
double crest(const Segment&, double left, double) { return left; }
double crest(const Arc& a, double left, double right) {
  return a.upper ? std::clamp(a.center.x, left, right) : left;
}
double crest(const Sine& s, double left, double right) {
  const double first = s.origin + s.wavelength * (s.amplitude > 0 ? 0.75 : 0.25);
  const double next = first + s.wavelength * std::ceil((left - first) / s.wavelength);
  return next < right ? next : left;
}

// Whether it is a number of px or px/frame, not a count, an angle or a share.
bool is_length(CaseCheck::Measure measure) {
  using M = CaseCheck::Measure;
  return measure != M::walls && measure != M::untouched && measure != M::normal && measure != M::changes &&
         measure != M::energy && measure != M::total_energy;
}

Vec2 range_of(const Segment& s) { return {s.from.x, s.to.x}; }
Vec2 range_of(const Arc& a) { return {a.x0, a.x1}; }
Vec2 range_of(const Sine& s) { return {s.x0, s.x1}; }

}  // namespace

std::optional<double> CaseFloor::top(double left, double right) const {
  std::optional<double> highest;
  for (const auto& part : parts) {
    std::visit(
        [&](const auto& form) {
          const Vec2 range = range_of(form);
          const double from = std::max(left, range.x), to = std::min(right, range.y);
          if (from > to) return;
          const double y = std::min({y_at(form, from), y_at(form, to), y_at(form, crest(form, from, to))});
          highest = std::min(highest.value_or(y), y);
        },
        part);
  }
  return highest;
}

HardCase scaled(const HardCase& hard, int factor) {
  HardCase image = hard;
  for (CaseInput& input : image.input) input.mouse = input.mouse * factor;
  for (auto& part : image.floor.parts) {
    part = std::visit(
        [&](const auto& form) -> decltype(CaseFloor::parts)::value_type {
          return std::get<std::decay_t<decltype(form)>>(scaled(Curve{form}, factor).form);
        },
        part);
  }
  for (CaseCheck& check : image.checks) {
    if (!is_length(check.measure)) continue;
    for (std::optional<double>* number : {&check.x, &check.y, &check.right, &check.bottom}) {
      if (*number) **number *= factor;
    }
    check.bound *= factor;
  }
  return image;
}

const std::array<CaseMeasureInfo, kCaseMeasureCount>& case_measure_infos() {
  using M = CaseCheck::Measure;
  static constexpr std::array<CaseMeasureInfo, kCaseMeasureCount> kInfos = {
      {{M::position, "position"},
       {M::velocity, "velocity"},
       {M::sink, "sink"},
       {M::gap, "gap"},
       {M::reaches, "reaches"},
       {M::backwards, "backwards"},
       {M::further, "further"},
       {M::walls, "walls"},
       {M::untouched, "untouched"},
       {M::normal, "normal"},
       {M::changes, "changes"},
       {M::energy, "energy"},
       {M::total_energy, "total_energy"},
       {M::apex, "apex"},
       {M::returns, "returns"},
       {M::mirror, "mirror"},
       {M::translate, "translate"},
       {M::permute, "permute"},
       {M::repeat, "repeat"}}};
  return kInfos;
}

}  // namespace talus
