// Files that a thread reads: finished at once or later, cancelled, and replaced by another file.
#include "session/files/file_reader.h"

#include <gtest/gtest.h>

#include <future>

namespace talus::file_reader_test {

using namespace std::chrono_literals;

class FileReaderTest : public ::testing::Test {
 protected:
  // Reads until it is cancelled, or the test lets it end.
  FileReader::Work slow(int result) {
    return [this, result](const Progress& progress) {
      while (progress.at(shares_ += 0.00001) && !may_end_) std::this_thread::sleep_for(1ms);
      has_ended_ = true;
      has_ended_.notify_all();
      return FileReader::Finish([this, result] { finished_.push_back(result); });
    };
  }
  FileReader::Work quick(int result) {
    return [this, result](const Progress&) {
      return FileReader::Finish([this, result] { finished_.push_back(result); });
    };
  }

  std::atomic<bool> may_end_ = false, has_ended_ = false;
  double shares_ = 0;
  std::vector<int> finished_;
  FileReader reader_;  // last, as it waits for work that uses the other members
};

TEST_F(FileReaderTest, AQuickReadEndsAtOnce) {
  reader_.start("a", quick(1), 24h);
  EXPECT_FALSE(reader_.is_busy());
  EXPECT_EQ(finished_, std::vector{1});
  EXPECT_FALSE(reader_.finish());
}

TEST_F(FileReaderTest, ASlowReadEndsLaterAndOnce) {
  reader_.start("big.talus.json", slow(1), 5ms);
  ASSERT_TRUE(reader_.is_busy());
  EXPECT_EQ(reader_.progress()->name, "big.talus.json");
  EXPECT_GE(reader_.progress()->seconds, 0.005);
  EXPECT_FALSE(reader_.finish());
  EXPECT_TRUE(finished_.empty());
  may_end_ = true;
  reader_.wait();
  EXPECT_EQ(finished_, std::vector{1});
  EXPECT_FALSE(reader_.progress());
}

TEST_F(FileReaderTest, ACancelledReadNeverEnds) {
  reader_.start("a", slow(1), 1ms);
  reader_.cancel();
  EXPECT_FALSE(reader_.is_busy());
  may_end_ = true;
  has_ended_.wait(false);
  EXPECT_FALSE(reader_.finish());
  reader_.start("b", quick(2), 24h);
  EXPECT_EQ(finished_, std::vector{2});
}

TEST_F(FileReaderTest, DestructionCancels) {
  {
    FileReader reader;
    reader.start("a", slow(1), 1ms);
  }
  EXPECT_TRUE(finished_.empty());
}

}  // namespace talus::file_reader_test
