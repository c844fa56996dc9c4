// SPDX-License-Identifier: MIT
#include "graspdb/database/search.h"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "support/ball_hands.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using testing::BallHands;
using testing::bytes_of;
using testing::database_of;
using testing::TemporaryDirectory;

// The oracle of the oracle: sort everything by (distance, row).
std::vector<Neighbor> brute_force(const std::vector<Descriptor>& rows, const Descriptor& query,
                                  int k) {
  std::vector<Neighbor> all;
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    std::uint32_t squared = 0;
    for (std::size_t i = 0; i < query.size(); ++i) {
      const int difference = query[i] - rows[row][i];
      squared += static_cast<std::uint32_t>(difference * difference);
    }
    all.push_back({row, squared});
  }
  std::ranges::sort(all, {},
                    [](const Neighbor& n) { return std::pair(n.squared_distance, n.row); });
  all.resize(std::min(all.size(), static_cast<std::size_t>(k)));
  return all;
}

Descriptor random_descriptor(std::uint64_t i, std::uint64_t values) {
  RandomStream random(5, i);
  Descriptor descriptor;
  for (std::uint8_t& value : descriptor) value = static_cast<std::uint8_t>(random.below(values));
  return descriptor;
}

std::vector<Descriptor> many(std::size_t count, Descriptor (*make)(std::uint64_t)) {
  std::vector<Descriptor> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = make(i);
  return all;
}

struct Distribution {
  std::string name;
  std::vector<Descriptor> rows;
};

std::vector<Distribution> distributions() {
  return {
      {"None", {}},
      {"One", {random_descriptor(0, 256)}},
      {"Uniform", many(1500, [](std::uint64_t i) { return random_descriptor(i, 256); })},
      {"Hands", many(1500, [](std::uint64_t i) { return BallHands::row(i * 97); })},
      // Most of them more than once, so that ties must be broken.
      {"Duplicates", many(1500, [](std::uint64_t i) { return random_descriptor(i % 40, 256); })},
      {"AllEqual", many(600, [](std::uint64_t) { return Descriptor{}; })},
      // The largest distance there is: 512 * 255^2.
      {"Extremes", many(513,
                        [](std::uint64_t i) {
                          Descriptor descriptor;
                          descriptor.fill(i % 2 == 0 ? 0 : 255);
                          return descriptor;
                        })},
  };
}

class SearchTest : public ::testing::TestWithParam<Distribution> {};
INSTANTIATE_TEST_SUITE_P(Of, SearchTest, ::testing::ValuesIn(distributions()),
                         [](const auto& of) { return of.param.name; });

TEST_P(SearchTest, ExactEqualsBruteForce) {
  const std::vector<Descriptor>& rows = GetParam().rows;
  const TemporaryDirectory directory;
  const Database database = database_of(directory / "a.graspdb", rows);
  const std::unique_ptr<Search> exact = make_exact_search(database);
  std::vector<Descriptor> queries = {Descriptor{}, random_descriptor(3, 256), BallHands::row(7)};
  if (!rows.empty()) queries.push_back(rows[rows.size() / 2]);
  for (const Descriptor& query : queries) {
    for (const int k : {0, 1, 2, 3, 20, 50, 511, 512, 1499, 1500, 5000}) {
      ASSERT_EQ(exact->nearest(query, k), brute_force(rows, query, k)) << "k = " << k;
    }
  }
}

TEST_P(SearchTest, LshGivesRowsOfTheirTrueDistanceInOrderAndAsManyAsThereAre) {
  const std::vector<Descriptor>& rows = GetParam().rows;
  const TemporaryDirectory directory;
  const Database database = database_of(directory / "a.graspdb", rows);
  const std::unique_ptr<Search> lsh = make_lsh_search(database);
  for (const Descriptor& query : {Descriptor{}, random_descriptor(3, 256), BallHands::row(7)}) {
    for (const int k : {0, 1, 20, 5000}) {
      const std::vector<Neighbor> all = brute_force(rows, query, 5000);
      const std::vector<Neighbor> found = lsh->nearest(query, k);
      ASSERT_EQ(found.size(), std::min<std::size_t>(static_cast<std::size_t>(k), rows.size()));
      const auto key = [](const Neighbor& n) { return std::pair(n.squared_distance, n.row); };
      EXPECT_TRUE(std::ranges::is_sorted(found, {}, key));
      for (const Neighbor& neighbor : found) {
        ASSERT_TRUE(std::ranges::binary_search(all, key(neighbor), {}, key)) << neighbor.row;
      }
    }
  }
}

TEST_P(SearchTest, ScanEqualsBruteForceWhenHardlyAnythingIsLeftOutOfTheCodes) {
  // Codes of nearly all directions lose little but their rounding, which 200 re-ranked rows make
  // good.
  const std::vector<Descriptor>& rows = GetParam().rows;
  const TemporaryDirectory directory;
  const Database database = database_of(directory / "a.graspdb", rows);
  const std::unique_ptr<Search> scan =
      make_scan_search(database, {.dimensions = kDescriptorSize - 2, .rerank = 200});
  for (const Descriptor& query :
       {random_descriptor(3, 256), BallHands::row(97), BallHands::row(7)}) {
    for (const int k : {0, 3, 5000}) {
      EXPECT_EQ(scan->nearest(query, k), brute_force(rows, query, k)) << "k = " << k;
    }
  }
}

TEST(ExactSearch, RefusesANegativeCount) {
  const TemporaryDirectory directory;
  const Database database = database_of(directory / "a.graspdb", {Descriptor{}});
  EXPECT_THROW(make_exact_search(database)->nearest({}, -1), std::logic_error);
}

// Three grasps, seen from a sixth of the sides.
class LshTest : public ::testing::Test {
 protected:
  static constexpr std::size_t kRows = 3 * BallHands::kSteps * BallHands::kViews / 6;
  static std::vector<Descriptor> hands() {
    return many(kRows, [](std::uint64_t i) { return BallHands::row(i * 6); });
  }
  static std::vector<Descriptor> queries(std::size_t count) {
    return many(count, [](std::uint64_t i) { return BallHands::query(i, 3); });
  }
  TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "hands.graspdb";
  Database database_ = database_of(path_, hands());
};

TEST_F(LshTest, FindsNineOfTenNeighborsByDefault) {
  EXPECT_GE(
      recall(*make_lsh_search(database_), *make_exact_search(database_), bytes_of(queries(40)), 20),
      0.9);
}

TEST_F(LshTest, FindsARowItself) {
  const std::unique_ptr<Search> lsh = make_lsh_search(database_, {.tables = 1, .probes = 1});
  Descriptor row;
  std::ranges::copy(database_.hog(123), row.begin());
  EXPECT_EQ(lsh->nearest(row, 1), (std::vector<Neighbor>{{123, 0}}));
}

TEST_F(LshTest, MoreTablesAndMoreProbesFindMore) {
  const std::unique_ptr<Search> exact = make_exact_search(database_);
  const auto found = [&](int tables, int probes) {
    const LshOptions options{.tables = tables, .hashes = 8, .width = 3, .probes = probes};
    return recall(*make_lsh_search(database_, options), *exact, bytes_of(queries(40)), 1);
  };
  // One neighbour is asked for, lest the search turns exact.
  EXPECT_LT(found(1, 4), 0.5);
  EXPECT_GT(found(4, 4), found(1, 4) + 0.2);
  EXPECT_GT(found(4, 40), found(4, 4) + 0.1);
}

TEST_F(LshTest, SameSeedSameAnswersOtherSeedOtherCandidates) {
  const auto answers = [&](std::uint64_t seed) {
    const std::unique_ptr<Search> lsh = make_lsh_search(
        database_, {.tables = 2, .hashes = 16, .width = 3, .probes = 10, .seed = seed});
    std::vector<std::vector<Neighbor>> all;
    for (const Descriptor& query : queries(20)) all.push_back(lsh->nearest(query, 20));
    return all;
  };
  EXPECT_EQ(answers(0), answers(0));
  EXPECT_NE(answers(0), answers(1));
}

TEST_F(LshTest, SearchesFromSeveralThreadsAtOnce) {
  const std::unique_ptr<Search> lsh = make_lsh_search(database_);
  const std::vector<Descriptor> all = queries(30);
  std::vector<std::vector<Neighbor>> alone(all.size()), together(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) alone[i] = lsh->nearest(all[i], 20);
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < all.size(); i += 3) together[i] = lsh->nearest(all[i], 20);
    });
  }
  threads.clear();
  EXPECT_EQ(together, alone);
}

TEST_F(LshTest, OptionsOutOfRangeAreRefusedByName) {
  const auto refused = [&](const LshOptions& options) -> std::string {
    try {
      make_lsh_search(database_, options);
      return "accepted";
    } catch (const Error& error) {
      return error.fault().key;
    }
  };
  EXPECT_EQ(refused({.tables = 0}), "tables");
  EXPECT_EQ(refused({.hashes = 33}), "hashes");
  EXPECT_EQ(refused({.width = 0}), "width");
  EXPECT_EQ(refused({.probes = 0}), "probes");
}

TEST_F(LshTest, ScanFindsNearlyEveryNeighbor) {
  const std::unique_ptr<Search> exact = make_exact_search(database_);
  EXPECT_GE(recall(*make_scan_search(database_), *exact, bytes_of(queries(40)), 20), 0.99);
  const std::unique_ptr<Search> coarse =
      make_scan_search(database_, {.dimensions = 6, .rerank = 80});
  EXPECT_LT(recall(*coarse, *exact, bytes_of(queries(40)), 20), 0.9) << "the test is too easy";
}

TEST_F(LshTest, ScanOptionsOutOfRangeAreRefusedByName) {
  EXPECT_THROW(make_scan_search(database_, {.dimensions = 0}), Error);
  EXPECT_THROW(make_scan_search(database_, {.dimensions = 127}), Error);
  EXPECT_THROW(make_scan_search(database_, {.dimensions = 514}), Error);
  EXPECT_THROW(make_scan_search(database_, {.rerank = 0}), Error);
}

TEST_F(LshTest, EachOfSeveralQueriesIsAnsweredAsByItself) {
  const std::vector<Descriptor> hands = LshTest::queries(3);
  const std::vector<DescriptorView> queries(hands.begin(), hands.end());
  for (const std::string& name : search_names()) {
    const std::unique_ptr<Search> search = open_search(database_, name);
    for (const int k : {0, 20, 5000}) {
      const auto found = search->nearest_of_each(queries, k);
      ASSERT_EQ(found.size(), 3u);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(found[i], search->nearest(queries[i], k)) << name;
    }
    EXPECT_TRUE(search->nearest_of_each({}, 20).empty());
  }
}

TEST_F(LshTest, EverySearchOpensByItsNameAndNoOther) {
  const std::unique_ptr<Search> exact = open_search(database_, "exact");
  for (const std::string& name : search_names())
    EXPECT_GE(recall(*open_search(database_, name), *exact, bytes_of(queries(20)), 5), 0.9) << name;
  try {
    open_search(database_, "ann");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().key, "search");
    EXPECT_EQ(error.fault().found, "ann");
  }
}

TEST(Recall, IsTheShareOfTheTrueNeighborsThatWereFound) {
  // A search that never gives odd rows.
  class EvenRows : public Search {
   public:
    explicit EvenRows(const Search& exact) : exact_(exact) {}
    std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
      std::vector<Neighbor> found = exact_.nearest(query, 2 * k);
      std::erase_if(found, [](const Neighbor& neighbor) { return neighbor.row % 2 == 1; });
      return found;
    }

   private:
    const Search& exact_;
  };
  const TemporaryDirectory directory;
  const Database database = database_of(directory / "a.graspdb", many(100, [](std::uint64_t i) {
                                          return Descriptor{static_cast<std::uint8_t>(i)};
                                        }));
  const std::unique_ptr<Search> exact = make_exact_search(database);
  EXPECT_EQ(recall(*exact, *exact, bytes_of({Descriptor{}}), 10), 1);
  EXPECT_EQ(recall(EvenRows(*exact), *exact, bytes_of({Descriptor{}}), 10), 0.5);
}

}  // namespace
}  // namespace graspdb
