#include "former_names.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

namespace talus {
namespace {

using nlohmann::json;

constexpr std::array kFormerNames = {
    FormerName{"watches", "plots"},
    FormerName{"watch", "plots"},
    FormerName{"watch/new_watch", "plots/new_plot"},
    FormerName{"watch/choose_times", "plots/choose_times"},
    FormerName{"tabs/watch", "tabs/plots"},
    FormerName{"stops", "breakpoints"},
    FormerName{"stops/forwards", "breakpoints/forwards"},
    FormerName{"stops/back", "breakpoints/back"},
    FormerName{"stops/new", "breakpoints/new"},
    FormerName{"stops/switch_all", "breakpoints/switch_all"},
    FormerName{"stops/kind", "breakpoints/kind"},
    FormerName{"stops/add", "breakpoints/add"},
    FormerName{"stops/pick", "breakpoints/pick"},
    FormerName{"tabs/stops", "tabs/breakpoints"},
};

// The name of today; the same name if that is no former one.
std::string name_today(const std::string& name) {
  const auto at = std::find_if(kFormerNames.begin(), kFormerNames.end(),
                               [&](const FormerName& each) { return each.former == name; });
  return std::string(at == kFormerNames.end() ? name : at->today);
}

void rename_keys(json& object) {
  json renamed = json::object();
  for (auto& [key, value] : object.items()) {
    const std::string today = name_today(key);
    if (today == key || !object.contains(today)) renamed[today] = std::move(value);
  }
  object = std::move(renamed);
}

}  // namespace

std::span<const FormerName> former_names() { return kFormerNames; }

void rename_former(json& settings) {
  rename_keys(settings);
  if (const auto tabs = settings.find("tabs"); tabs != settings.end() && tabs->is_array()) {
    for (json& tab : *tabs)
      if (tab.is_string()) tab = name_today(tab.get<std::string>());
  }
  const auto preferences = settings.find("preferences");
  if (preferences == settings.end() || !preferences->is_object()) return;
  const auto keys = preferences->find("keys");
  if (keys != preferences->end() && keys->is_object()) rename_keys(*keys);
}

}  // namespace talus
