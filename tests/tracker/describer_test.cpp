// SPDX-License-Identifier: MIT
#include "graspdb/tracker/describer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "features/net_bytes.h"
#include "features/pictures.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/features/embedding.h"
#include "graspdb/features/hog.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Picture;
using testing::random_picture;
using testing::small_net;
using testing::TemporaryDirectory;

class DescriberTest : public ::testing::Test {
 protected:
  DescriberTest() { write_text(weights_, small_net(1).bytes()); }

  Database database_of(const DatabaseInfo& info) {
    write_database(directory_ / "a.graspdb", info, testing::toy_rows(2, info.embedding_bytes));
    return Database::open(directory_ / "a.graspdb");
  }
  DatabaseInfo learned() {
    DatabaseInfo info = testing::toy_info(64);
    info.weights = EmbeddingNet::load(weights_).hash();
    return info;
  }

  TemporaryDirectory directory_;
  std::filesystem::path weights_ = directory_ / "net.safetensors";
  Picture picture_ = random_picture(1, 60, 80, 3);
};

TEST_F(DescriberTest, DescribesAsTheRowsWere) {
  const Describer hog(database_of(testing::toy_info()));
  const Descriptor expected = describe(picture_.gray, picture_.mask, HogMode::kPaper);
  EXPECT_TRUE(std::ranges::equal(hog.describe(picture_.gray, picture_.mask), expected));

  const Describer net(database_of(learned()), weights_);
  EXPECT_EQ(net.describe(picture_.gray, picture_.mask),
            EmbeddingNet::load(weights_).describe(
                crop_hand(picture_.gray, picture_.mask, *crop_square(picture_.mask))));
}

TEST_F(DescriberTest, AnEmptyMaskHasNoBytes) {
  const Describer net(database_of(learned()), weights_);
  EXPECT_THAT(net.describe(GrayImage(20, 20, 77), Mask(20, 20)), IsEmpty());
}

TEST_F(DescriberTest, OtherWeightsThanTheRowsAreRefusedByName) {
  const Database database = database_of(learned());
  write_text(directory_ / "other.safetensors", small_net(2).bytes());
  for (const std::filesystem::path& weights :
       {directory_ / "other.safetensors", std::filesystem::path()}) {
    try {
      const Describer describer(database, weights);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr(weights.empty() ? "toy.safetensors" : "other.safetensors"));
    }
  }
}

}  // namespace
}  // namespace graspdb
