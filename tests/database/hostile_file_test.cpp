// SPDX-License-Identifier: MIT
// Whatever a file holds, it opens with its meaning intact or is refused by an Error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "graspdb/database/database.h"
#include "sealed_file.h"
#include "support/replaced.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using testing::FileParts;
using testing::replaced;
using testing::sealed;

class HostileFile : public ::testing::Test {
 protected:
  void SetUp() override {
    write_database(path_, testing::toy_info(), testing::toy_rows(2));
    good_ = read_text(path_);
    parts_ = testing::take_apart(good_);
  }

  // The Error that these bytes give, if any.
  std::optional<Error> error_of(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return error_of_file();
  }
  std::optional<Error> error_of_file() {
    try {
      verify_database(path_);
      return std::nullopt;
    } catch (const Error& error) {
      return error;
    }
  }
  void expect_refused(const std::string& bytes, const std::string& key) {
    const std::optional<Error> error = error_of(bytes);
    ASSERT_TRUE(error) << "accepted; expected a fault in " << key;
    EXPECT_EQ(error->fault().key, key) << error->what();
    EXPECT_EQ(error->fault().file, path_.string());
  }
  // The header with one text replaced, and its checksum made true again.
  std::string with(const std::string& from, const std::string& to) {
    EXPECT_NE(parts_.header.find(from), std::string::npos) << from;
    return sealed({replaced(parts_.header, from, to), parts_.data});
  }

  testing::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "toy.graspdb";
  std::string good_;
  FileParts parts_;
};

TEST_F(HostileFile, TheUnalteredFileIsAcceptedAndSoIsItsCopySealedByTheTest) {
  EXPECT_FALSE(error_of(good_));
  EXPECT_EQ(sealed(parts_), good_);
}

TEST_F(HostileFile, EveryTruncationIsRefused) {
  for (std::size_t size = good_.size(); size-- > 0;) {
    std::filesystem::resize_file(path_, size);
    ASSERT_TRUE(error_of_file()) << size;
  }
}

TEST_F(HostileFile, EveryChangedByteIsRefused) {
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  const auto put = [&](std::size_t at, char byte) {
    file.seekp(static_cast<std::streamoff>(at)).put(byte).flush();
  };
  for (std::size_t at = 0; at < good_.size(); ++at) {
    put(at, static_cast<char>(good_[at] ^ (1 << at % 8)));
    ASSERT_TRUE(error_of_file()) << at;
    put(at, good_[at]);
  }
  EXPECT_FALSE(error_of_file());
}

TEST_F(HostileFile, EveryChangedHeaderByteUnderATrueChecksumIsRefusedOrHarmless) {
  RandomStream random(3);
  for (std::size_t at = 0; at < parts_.header.size(); ++at) {
    FileParts parts = parts_;
    parts.header[at] = static_cast<char>(random.below(256));
    if (error_of(sealed(parts))) continue;
    const Database database = Database::open(path_);
    ASSERT_EQ(database.rows(), 2u) << at;
    ASSERT_TRUE(std::ranges::equal(database.hog(1), testing::toy_row(1).hog)) << at;
  }
}

TEST_F(HostileFile, TrailingBytesAreRefused) {
  expect_refused(good_ + '\0', "data");
}

TEST_F(HostileFile, AnAbsurdLengthOfTheHeaderIsRefused) {
  for (const std::uint64_t length :
       {std::uint64_t{0}, std::uint64_t{good_.size()}, std::uint64_t{good_.size() - 7},
        ~std::uint64_t{0}, ~std::uint64_t{0} - 8, std::uint64_t{1} << 63}) {
    std::string bytes = good_;
    std::memcpy(bytes.data(), &length, 8);
    expect_refused(bytes, "header");
  }
}

TEST_F(HostileFile, AnotherKindOfFileIsRefused) {
  expect_refused("", "header");
  expect_refused("not a database at all, but a text of some length", "header");
  expect_refused(testing::put_together({"{}", ""}), "header");
}

TEST_F(HostileFile, AnotherVersionIsRefusedByName) {
  expect_refused(with(R"("format_version":"1")", R"("format_version":"3")"), "format_version");
  expect_refused(with(R"("format_version":"1")", R"("format_version":"2")"), "header.embedding");
}

TEST_F(HostileFile, AMissingChecksumIsRefused) {
  expect_refused(with(R"("header_hash":)", R"("other_hash":)"), "header_hash");
}

TEST_F(HostileFile, AWrongColumnIsRefusedByName) {
  expect_refused(with(R"("dtype":"U16")", R"("dtype":"I16")"), "grasp");
  expect_refused(with(R"("shape":[2,512])", R"("shape":[2,511])"), "hog");
  expect_refused(with(R"("shape":[2,512])", R"("shape":[512,2])"), "hog");
  expect_refused(with(R"("view":{)", R"("look":{)"), "header.view");
  expect_refused(with(R"("step":{)", R"("extra":{},"step":{)"), "header");
  expect_refused(with(R"("step":{)", R"("step":[],"hand":{)"), "header");
}

TEST_F(HostileFile, OffsetsThatOverlapLeaveHolesOrOverflowAreRefused) {
  const std::string view = R"("data_offsets":[280,288])";
  for (const char* offsets :
       {"[279,287]", "[281,289]", "[288,280]", "[-8,0]", "[280]", "[280,1e30]",
        "[18446744073709551615,18446744073709551615]", "\"280\""}) {
    expect_refused(with(view, std::string(R"("data_offsets":)") + offsets), "view");
  }
}

TEST_F(HostileFile, AnAbsurdNumberOfRowsIsRefused) {
  const std::string label = R"("shape":[2,31])";
  for (const char* rows : {"[-1,31]", "[4294967296,31]", "[18446744073709551615,31]", "[1e3,31]",
                           "[]", "2", "[\"2\",31]", "[null,31]"}) {
    expect_refused(with(label, std::string(R"("shape":)") + rows), "label.shape");
  }
  expect_refused(with(label, R"("shape":[4294967295,31])"), "label");
}

TEST_F(HostileFile, RowsThatDoNotFitTheFileAreRefused) {
  // Every column says 3 rows, as if one was lost.
  write_database(path_, testing::toy_info(), testing::toy_rows(3));
  const FileParts three = testing::take_apart(read_text(path_));
  expect_refused(sealed({three.header, parts_.data}), "data");
}

TEST_F(HostileFile, AKeyThatStandsTwiceIsRefused) {
  expect_refused(with(R"("step":{)", R"("view":{},"step":{)"), "header");
  expect_refused(with(R"("views":"8")", R"("views":"8","views":"8")"), "header");
}

TEST_F(HostileFile, DeepNestingIsRefused) {
  const std::string deep(1'000'000, '[');
  expect_refused(with(R"("step":{)", R"("x":)" + deep + R"(,"step":{)"), "header");
  expect_refused(with(R"("views":"8")", R"("views":")" + deep + "\""), "__metadata__.views");
}

TEST_F(HostileFile, BrokenMetadataIsRefusedByName) {
  expect_refused(with(R"("steps":"5")", R"("steps":5)"), "__metadata__.steps");
  expect_refused(with(R"("steps":"5")", R"("steps":"five")"), "__metadata__.steps");
  expect_refused(with(R"("steps":"5")", R"("steps":"-5")"), "__metadata__.steps");
  expect_refused(with(R"("steps":"5")", R"("steps":"0")"), "steps");
  expect_refused(with(R"("views":"8")", R"("views":"3000000000")"), "__metadata__.views");
  expect_refused(with(R"("tool":)", R"("data_card":"{","tool":)"), "__metadata__.data_card");
  expect_refused(with(R"("tool":)", R"("data_card":{},"tool":)"), "__metadata__.data_card");
  expect_refused(with(R"("tool":)", R"("fool":)"), "__metadata__.tool");
  expect_refused(with(R"(\"id\":9)", R"(\"id\":1)"), "grasps.id");
  expect_refused(with(R"(\"id\":9)", R"(\"id\":\"9\")"), "grasps.id");
  expect_refused(with(R"(\"id\":9)", R"(\"id\":18446744069414584329)"), "grasps.id");
  expect_refused(with(R"("grasps":"[)", R"("grasps":"[[],)"), "grasps");
  expect_refused(with(R"("variants":"[)", R"("variants":"[1,)"), "variants");
  expect_refused(with(R"(\"index_middle\")", R"(\"index_riddle\")"),
                 "skeleton.palm_from_bone_at_zero.index_middle");
  expect_refused(with(R"({\"resolution\":128})", R"({\"resolution\":129})"), "config_hash");
}

TEST_F(HostileFile, RowsThatNoReaderCouldLookUpAreRefusedThoughTheChecksumsAreTrue) {
  // The same rows under an info with fewer grasps, steps, views, hands and variants.
  expect_refused(with(R"(\"id\":1,)", R"(\"id\":2,)"), "grasp[0]");
  expect_refused(with(R"("views":"8")", R"("views":"1")"), "view[1]");
  expect_refused(with(R"("variants":"[\"held\",\"free\"]")", R"("variants":"[]")"), "variant[0]");
  std::vector<Row> rows = testing::toy_rows(2);
  rows[1].step = 5;
  write_database(path_, testing::toy_info(), rows);
  parts_ = testing::take_apart(read_text(path_));
  expect_refused(with(R"("steps":"5")", R"("steps":"4")"), "step[1]");
}

TEST_F(HostileFile, ALabelThatIsNotFiniteIsRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  FileParts parts = parts_;
  const std::string before = hash_hex(parts.data.substr(0, 248));
  std::memcpy(parts.data.data() + std::size_t{4} * 31, &nan, 4);
  parts.header = replaced(parts.header, before, hash_hex(parts.data.substr(0, 248)));
  // The content hash is made of the columns' hashes, in their order.
  const auto hashes = nlohmann::ordered_json::parse(
      nlohmann::ordered_json::parse(parts.header)["__metadata__"]["column_hashes"]
          .get<std::string>());
  std::string all;
  for (const auto& hash : hashes) all += hash.get<std::string>();
  const std::string old = Database::open(path_).content_hash();
  parts.header = replaced(parts.header, old, hash_hex(all));
  expect_refused(sealed(parts), "label[1]");
}

TEST_F(HostileFile, AFolderOrNothingAtAllIsRefused) {
  EXPECT_THROW(Database::open(directory_.path()), Error);
  EXPECT_THROW(Database::open(directory_ / "none.graspdb"), Error);
}

}  // namespace
}  // namespace graspdb
