#include "example_list.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <span>

namespace talus {
namespace {

struct CaseTheme {
  std::string_view label, help;
  std::span<const int> numbers;  // of hard cases; empty: all that no other theme has
};

constexpr int kSeams[] = {1, 2, 3, 7, 21}, kSlopes[] = {4, 5, 6, 8, 12, 13, 14, 15, 16},
              kWalls[] = {9, 10, 11, 17, 20, 22, 23}, kRest[] = {26, 27, 28, 29, 30, 61, 66},
              kCurves[] = {38, 39}, kPairs[] = {37, 40, 41, 42, 43, 44, 54, 58, 64, 65},
              kRolling[] = {53, 57, 59, 60};
constexpr std::array kThemes = {
    CaseTheme{"Seams", "Hard cases: bodies that catch on the border of two tiles.", kSeams},
    CaseTheme{"Slopes", "Hard cases: peaks, valleys, and ways up and down.", kSlopes},
    CaseTheme{"Walls", "Hard cases: walls, wedges, ceilings and thin floors.", kWalls},
    CaseTheme{"Rest and bounce", "Hard cases: bodies that should lie still, or bounce for ever.", kRest},
    CaseTheme{"Curves", "Hard cases: ground that is round.", kCurves},
    CaseTheme{"Meetings", "Hard cases: bodies that hit one another, and stand on one another.", kPairs},
    CaseTheme{"Rolling", "Hard cases: bodies that are round and roll, and ground that moves.", kRolling},
    CaseTheme{"Exactness", "Hard cases: touches, order, and numbers at their limits.", {}}};

int number_of_case(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  int number = 0;
  std::from_chars(name.data(), name.data() + name.size(), number);
  return number;
}

// The theme that names the number, else the last one.
std::size_t theme_of(int number) {
  const auto names_it = [&](const CaseTheme& theme) {
    return std::find(theme.numbers.begin(), theme.numbers.end(), number) != theme.numbers.end();
  };
  const auto found = std::find_if(kThemes.begin(), kThemes.end() - 1, names_it);
  return static_cast<std::size_t>(found - kThemes.begin());
}

}  // namespace

std::vector<ExampleGroup> example_groups(const FilesView& files) {
  std::vector<ExampleGroup> groups{{"Scenes", "Levels to run around in.", files.scenes}};
  for (const CaseTheme& theme : kThemes) groups.push_back({theme.label, theme.help, {}});
  for (const std::string& file : files.hard_cases)
    groups[1 + theme_of(number_of_case(file))].files.push_back(file);
  std::erase_if(groups, [](const ExampleGroup& group) { return group.files.empty(); });
  return groups;
}

}  // namespace talus
