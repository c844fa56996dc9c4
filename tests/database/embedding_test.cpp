// SPDX-License-Identifier: MIT
// Databases of version 2: rows with the codes of a learned descriptor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "database/sealed_file.h"
#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "graspdb/database/database.h"
#include "graspdb/database/search.h"
#include "support/replaced.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;
using testing::toy_info;
using testing::toy_rows;

const std::filesystem::path kGoldenOfCodes =
    std::filesystem::path(GRASPDB_SOURCE_DIR) / "tests/database/golden/v2.graspdb";

class Embeddings : public ::testing::TestWithParam<std::size_t> {
 protected:
  Database write(std::size_t rows) {
    write_database(path_, toy_info(GetParam()), toy_rows(rows, GetParam()));
    return Database::open(path_);
  }
  TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "a.graspdb";
};
INSTANTIATE_TEST_SUITE_P(Of, Embeddings, ::testing::Values(64, 128));

TEST_P(Embeddings, ComeBackBesideTheHogs) {
  const Database database = write(50);
  const std::vector<Row> rows = toy_rows(50, GetParam());
  EXPECT_TRUE(database.has_embeddings());
  EXPECT_EQ(database.info().descriptor, "toy");
  EXPECT_EQ(database.info().weights, toy_info(GetParam()).weights);
  ASSERT_EQ(database.descriptors().rows(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_TRUE(std::ranges::equal(database.descriptors().row(i), rows[i].embedding));
    EXPECT_TRUE(std::ranges::equal(database.hog(i), rows[i].hog));
  }
  EXPECT_NO_THROW(verify_database(path_));
}

TEST_P(Embeddings, AreWhatIsSearched) {
  const Database database = write(3000);
  const std::vector<Row> rows = toy_rows(3000, GetParam());
  const DescriptorBytes query = toy_rows(4000, GetParam()).back().embedding;
  std::vector<Neighbor> all;
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    std::uint32_t squared = 0;
    for (std::size_t k = 0; k < query.size(); ++k) {
      const int difference = query[k] - rows[row].embedding[k];
      squared += static_cast<std::uint32_t>(difference * difference);
    }
    all.push_back({row, squared});
  }
  std::ranges::sort(all, {},
                    [](const Neighbor& n) { return std::pair(n.squared_distance, n.row); });
  all.resize(20);
  EXPECT_EQ(make_exact_search(database)->nearest(query, 20), all);
  // Of random codes nothing is near: only what looks at all rows finds the same.
  EXPECT_EQ(make_scan_search(database, {.dimensions = 32, .rerank = 2999})->nearest(query, 20),
            all);
  EXPECT_EQ(make_lsh_search(database)->nearest(query, 20).size(), 20u);
  for (const std::string& name : search_names()) {
    EXPECT_EQ(open_search(database, name)->nearest(rows[77].embedding, 1).at(0), (Neighbor{77, 0}))
        << name;
  }
}

// Codes that follow five numbers, as those of views follow their poses, and noise.
std::vector<Row> smooth_rows(std::size_t count, std::size_t bytes) {
  RandomStream slopes_random(1), random(2);
  std::vector<double> slopes(bytes * 5);
  for (double& slope : slopes) slope = 2 * slopes_random.normal();
  std::vector<Row> rows = toy_rows(count, bytes);
  for (Row& row : rows) {
    std::array<double, 5> place;
    for (double& number : place) number = random.uniform();
    for (std::size_t i = 0; i < bytes; ++i) {
      const double phase =
          std::inner_product(place.begin(), place.end(), slopes.begin() + 5 * i, 0.0);
      row.embedding[i] =
          static_cast<std::uint8_t>(std::lround(128 + 40 * std::sin(phase) + 2 * random.normal()));
    }
  }
  return rows;
}

TEST_P(Embeddings, ScanFindsNearlyAllOfTheNearest) {
  std::vector<Row> rows = smooth_rows(5000, GetParam());
  std::vector<DescriptorBytes> queries;
  for (std::size_t i = 4960; i < rows.size(); ++i) queries.push_back(rows[i].embedding);
  rows.resize(4800);
  write_database(path_, toy_info(GetParam()), rows);
  const Database database = Database::open(path_);
  const auto exact = make_exact_search(database);
  EXPECT_GE(recall(*make_scan_search(database), *exact, queries, 20), 0.99);
  // Few are compared exactly, but never so few that the k nearest are those of the codes.
  const auto least = make_scan_search(database, {.dimensions = 8, .rerank = 1});
  EXPECT_GE(recall(*least, *exact, queries, 20), 0.9);
  EXPECT_LT(recall(*least, *exact, queries, 20), 1);
}

TEST_P(Embeddings, PartsOfOtherWeightsAreNotJoined) {
  DatabaseInfo info = toy_info(GetParam());
  info.variants = {"held"};
  write_database(path_, info, toy_rows(80, GetParam()));
  join_databases(directory_ / "joined.graspdb", info, std::vector<DatabasePart>{{path_, 0, 0}});
  EXPECT_TRUE(std::ranges::equal(Database::open(directory_ / "joined.graspdb").descriptors().bytes,
                                 Database::open(path_).descriptors().bytes));
  DatabaseInfo other = info;
  other.weights[0] = 'f';
  try {
    join_databases(directory_ / "other.graspdb", other, std::vector<DatabasePart>{{path_, 0, 0}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().key, "weights");
  }
}

TEST(Database, WithoutEmbeddingsIsSearchedByItsHogs) {
  const TemporaryDirectory directory;
  write_database(directory / "a.graspdb", toy_info(), toy_rows(3));
  const Database database = Database::open(directory / "a.graspdb");
  EXPECT_FALSE(database.has_embeddings());
  EXPECT_EQ(database.descriptors().bytes.data(), database.hogs().bytes.data());
}

// A header that is sealed, but whose embeddings are none.
TEST(Embeddings, OfAnotherSizeOrNoneAreRefused) {
  const TemporaryDirectory directory;
  write_database(directory / "a.graspdb", toy_info(64), toy_rows(4, 64));
  const auto parts = testing::take_apart(read_text(directory / "a.graspdb"));
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {R"("shape":[4,64])", R"("shape":[4,96])"},
           {R"("shape":[4,64])", R"("shape":64)"},
           {R"("embedding":{"dtype)", R"("embeddings":{"dtype)"},
           {R"("format_version":"2")", R"("format_version":"1")"},
           {R"("format_version":"2")", R"("format_version":"3")"},
           {R"("weights_hash")", R"("weights_cash")"}}) {
    testing::FileParts altered = parts;
    altered.header = testing::replaced(parts.header, from, to);
    ASSERT_NE(altered.header, parts.header) << from;
    write_text(directory / "b.graspdb", testing::sealed(altered));
    EXPECT_THROW(Database::open(directory / "b.graspdb"), Error) << to;
  }
}

TEST(GoldenDatabase, OfVersion2IsWhatTheWriterWrites) {
  EXPECT_NO_THROW(verify_database(kGoldenOfCodes));
  const TemporaryDirectory directory;
  write_database(directory / "again.graspdb", toy_info(64), toy_rows(3, 64));
  EXPECT_EQ(read_text(directory / "again.graspdb"), read_text(kGoldenOfCodes));
}

}  // namespace
}  // namespace graspdb
