// SPDX-License-Identifier: MIT
// Whatever a database file holds: it verifies and every row can be looked up, or an Error refuses
// it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "database/sealed_file.h"
#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "graspdb/database/database.h"
#include "memory_file.h"

namespace graspdb {
namespace {

using nlohmann::ordered_json;

bool is_sound(const Database& database, std::size_t row) {
  const DatabaseInfo& info = database.info();
  return database.hand(row) < info.hands.size() && database.variant(row) < info.variants.size() &&
         database.view(row) < static_cast<std::uint32_t>(info.views) && database.step(row) >= 1 &&
         database.step(row) <= info.steps &&
         std::ranges::count(info.grasps, database.grasp(row), &GraspEntry::id) == 1 &&
         is_finite(database.label(row));
}

void expect_sound_or_refused(const std::string& bytes) {
  const testing::MemoryFile file(bytes);
  try {
    verify_database(file.path());
    const Database database = Database::open(file.path());
    for (std::size_t row = 0; row < database.rows(); ++row) {
      if (!is_sound(database, row)) std::abort();
    }
  } catch (const Error&) {
  }
}

std::string replaced_where_found(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// Makes the checksums of the columns true as far as the header can still be read.
void make_column_hashes_true(testing::FileParts& parts) {
  std::string header = parts.header;
  try {
    const auto root = ordered_json::parse(header);
    const ordered_json& metadata = root.at("__metadata__");
    const auto hashes = ordered_json::parse(metadata.at("column_hashes").get<std::string>());
    std::string all;
    for (const auto& [name, hash] : hashes.items()) {
      const auto offsets = root.at(name).at("data_offsets").get<std::vector<std::size_t>>();
      const std::string found =
          hash_hex(parts.data.substr(offsets.at(0), offsets.at(1) - offsets.at(0)));
      const std::string entry = name + R"(\":\")";  // two columns can have one checksum
      header = replaced_where_found(header, entry + hash.get<std::string>(), entry + found);
      all += found;
    }
    parts.header =
        replaced_where_found(header, metadata.at("content_hash").get<std::string>(), hash_hex(all));
  } catch (const std::exception&) {
  }
}

// Nearly every altered file fails at a checksum; with true ones the readers behind see it.
void expect_sealed_sound_or_refused(const std::string& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < sizeof(length)) return;
  std::memcpy(&length, bytes.data(), sizeof(length));
  if (length > bytes.size() - sizeof(length)) return;
  testing::FileParts parts = testing::take_apart(bytes);
  make_column_hashes_true(parts);
  expect_sound_or_refused(testing::sealed(parts));
}

}  // namespace
}  // namespace graspdb

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// Half of the time one byte changes and the size does not, or hardly a file would get as far as its
// columns; the nearer to the end the likelier, where the smallest columns lie.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  graspdb::RandomStream random(seed);
  if (size == 0 || random.below(2) == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t reach = std::min(size, std::size_t{1} << random.below(14));
  data[size - 1 - random.below(reach)] = static_cast<std::uint8_t>(random.below(256));
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(graspdb::testing::text_of(data, size));
  graspdb::expect_sound_or_refused(bytes);
  graspdb::expect_sealed_sound_or_refused(bytes);
  return 0;
}
