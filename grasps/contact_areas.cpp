// SPDX-License-Identifier: MIT
#include "contact_areas.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "graspdb/hand/skeleton.h"

namespace graspdb {
namespace {

ContactArea area(std::string name, int digit, int bone, double from, double to,
                 SkinSide side = SkinSide::kPalmar) {
  return {std::move(name), digit, bone, side, from, to};
}

std::vector<ContactArea> palm_areas() {
  return {area("pads", 0, kPalm, 0.75, 1.15), area("hollow", 0, kPalm, 0.35, 0.75),
          area("heel", 0, kPalm, 0, 0.35)};
}

std::vector<ContactArea> areas_of(int digit) {
  if (digit == 0) return palm_areas();
  const bool thumb = digit == 1;
  const int distal = distal_bone(without_palm(digit));
  std::vector<ContactArea> areas = {area("pulp", digit, distal, 0.3, 0.85),
                                    area("tip", digit, distal, 0.6, 1.2),
                                    area("distal", digit, distal, 0, 1.2)};
  if (thumb) areas.push_back(area("thenar", digit, kThumbMetacarpal, 0, 1));
  if (!thumb) areas.push_back(area("middle", digit, distal - 1, 0, 1));
  areas.push_back(area("proximal", digit, thumb ? kThumbProximal : distal - 2, 0, 1));
  const auto palmar = areas;
  for (const auto& [suffix, side] :
       {std::pair("_radial", SkinSide::kRadial), {"_ulnar", SkinSide::kUlnar}}) {
    for (const ContactArea& a : palmar) {
      areas.push_back(area(a.name + suffix, digit, a.bone, a.from, a.to, side));
    }
  }
  return areas;
}

}  // namespace

std::optional<ContactArea> contact_area(int digit, std::string_view name) {
  const std::vector<ContactArea> areas = areas_of(digit);
  const auto found = std::find_if(areas.begin(), areas.end(),
                                  [&](const ContactArea& a) { return a.name == name; });
  return found == areas.end() ? std::nullopt : std::optional(*found);
}

std::string contact_area_names(int digit) {
  std::vector<std::string> names;
  for (const ContactArea& a : areas_of(digit)) names.push_back(a.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<int> digit_from_name(std::string_view name) {
  const auto found = std::find(kPalmAndDigitNames.begin(), kPalmAndDigitNames.end(), name);
  if (found == kPalmAndDigitNames.end()) return std::nullopt;
  return static_cast<int>(found - kPalmAndDigitNames.begin());
}

}  // namespace graspdb
