// What every reader of documents promises, for hundreds of documents in the grammar of its format. The
// fuzzers try more of them. TALUS_DOCUMENTS: the number of documents of each format, at least the one that
// the test has.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "fuzz/document_checks.h"
#include "fuzz/grammar.h"
#include "platform/settings.h"
#include "tries.h"

namespace talus::documents_test {

using Check = std::function<Checked(std::string_view)>;

std::string random_bytes(std::mt19937& random) {
  std::string bytes(1 + random() % 600, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

// Tries `least` documents, or more at night, and expects that some of them are read and some are refused.
void expect_promises(const std::string& seed, int least, const Check& check, bool by_lines = false) {
  const int count = static_cast<int>(tries("TALUS_DOCUMENTS", least));
  const Grammar grammar = grammar_of_seed(seed);
  std::mt19937 random(15);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    const std::string bytes = random_bytes(random);
    RandomBytes choices(bytes);
    const std::string document = by_lines ? grammar.lines(choices) : grammar.document(choices);
    Checked checked;
    try {
      checked = check(document);
    } catch (const std::exception& error) {
      checked.problem = std::string("an exception leaves the reader: ") + error.what();
    }
    read += checked.is_read ? 1 : 0;
    ASSERT_EQ(checked.problem, "") << "document " << i << ":\n" << document.substr(0, 5000);
  }
  EXPECT_GT(read, count / 50) << "too few documents are good";
  EXPECT_LT(read, count) << "too few documents are bad";
}

TEST(Documents, TheSeedsAreReadable) {
  RandomBytes none("");
  EXPECT_TRUE(check_native(grammar_of_seed("all.talus.json").document(none)).is_read);
  EXPECT_TRUE(check_recording(grammar_of_seed("small.talusrec").document(none)).is_read);
  EXPECT_TRUE(check_scenario(grammar_of_seed("moves.scenario.json").document(none)).is_read);
  EXPECT_TRUE(check_input(grammar_of_seed("keys.jsonl").lines(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("small.tmj").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("small.tmx").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("infinite.tmj").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("infinite.tmx").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("old.tmj").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("sets.tmx").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("small.tsx").document(none)).is_read);
  EXPECT_TRUE(check_tiled(grammar_of_seed("small.tsj").document(none)).is_read);
  EXPECT_TRUE(check_ldtk(grammar_of_seed("small.ldtk").document(none)).is_read);
  EXPECT_TRUE(check_ldtk_companion(grammar_of_seed("added.ldtkc").document(none)).is_read);
}

TEST(Documents, NativeLevels) { expect_promises("all.talus.json", 250, check_native); }
TEST(Documents, Recordings) { expect_promises("small.talusrec", 250, check_recording); }
TEST(Documents, Scenarios) { expect_promises("moves.scenario.json", 250, check_scenario); }
TEST(Documents, Inputs) { expect_promises("keys.jsonl", 250, check_input, true); }
TEST(Documents, MapsOfTiledInJson) { expect_promises("small.tmj", 100, check_tiled); }
TEST(Documents, MapsOfTiledInXml) { expect_promises("small.tmx", 100, check_tiled); }
TEST(Documents, InfiniteMapsInJson) { expect_promises("infinite.tmj", 100, check_tiled); }
TEST(Documents, InfiniteMapsInXml) { expect_promises("infinite.tmx", 100, check_tiled); }
TEST(Documents, MapsOfTiledInOldJson) { expect_promises("old.tmj", 100, check_tiled); }
TEST(Documents, MapsOfTiledWithManyTilesets) { expect_promises("sets.tmx", 100, check_tiled); }
TEST(Documents, TilesetsOfTiledInJson) { expect_promises("small.tsj", 100, check_tiled); }
TEST(Documents, TilesetsOfTiledInXml) { expect_promises("small.tsx", 100, check_tiled); }

TEST(Documents, ProjectsOfLdtk) { expect_promises("small.ldtk", 250, check_ldtk); }
TEST(Documents, CompanionsOfProjectsOfLdtk) { expect_promises("added.ldtkc", 250, check_ldtk_companion); }

TEST(Documents, Settings) {
  expect_promises("settings.json", 400, [](std::string_view document) {
    const auto settings = settings_of_text(document);
    return settings ? Checked{true} : checked_error(settings.error());
  });
}

}  // namespace talus::documents_test
