// SPDX-License-Identifier: MIT
// An index file: 8 bytes length of the header, the header (JSON), for each table its keys (u64),
// starts and rows (u32), and 32 hexadecimal digits, the checksum of all before them.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "graspdb/file.h"
#include "graspdb/hash.h"
#include "lsh.h"
#include "mapped_file.h"
#include "refuse.h"
#include "strict_json.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::string_view kFormat = "graspdb-lsh";
constexpr std::size_t kHashDigits = 32;
constexpr std::size_t kMaxHeader = 1 << 20;

template <typename T>
void append(std::string& bytes, std::span<const T> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

std::string index_bytes(const LshIndex& index, const Database& database) {
  json keys = json::array();
  for (const LshTable& table : index.tables) keys.push_back(table.keys.size());
  const std::string header = json{
      {"format", kFormat},
      {"format_version", "1"},
      {"content_hash", database.content_hash()},
      {"rows", database.rows()},
      {"tables", index.options.tables},
      {"hashes", index.options.hashes},
      {"width", index.options.width},
      {"probes", index.options.probes},
      {"seed", std::to_string(index.options.seed)},
      {"cell", index.cell},
      {"keys", keys}}.dump();
  const std::uint64_t length = header.size();
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += header;
  for (const LshTable& table : index.tables) {
    append<std::uint64_t>(bytes, table.keys);
    append<std::uint32_t>(bytes, table.starts);
    append<std::uint32_t>(bytes, table.rows);
  }
  return bytes + hash_hex(bytes);
}

// Takes values from the front of bytes, which may be too few.
class Reader {
 public:
  Reader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) {
      refuse(file_, "data", fmt::format("{} bytes", size), fmt::format("{}", bytes_.size()));
    }
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  template <typename T>
  std::vector<T> values(std::size_t count) {
    if (count > bytes_.size()) refuse(file_, "data", fmt::format("{} numbers", count), "fewer");
    std::vector<T> values(count);
    std::memcpy(values.data(), take(count * sizeof(T)).data(), count * sizeof(T));
    return values;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  std::string file_;
};

double number(const JsonFields& header, const std::string& key, const std::string& file) {
  const json& value = header.at(key);
  if (!value.is_number()) refuse(file, key, "a number", value.dump());
  return value.get<double>();
}

// Refuses an index of other rows before anything else of it is used.
void check_belongs(const JsonFields& header, const Database& database, const std::string& file) {
  if (header.text("format") != kFormat)
    refuse(file, "format", "graspdb-lsh", header.text("format"));
  if (header.text("format_version") != "1") {
    refuse(file, "format_version", "1", header.text("format_version"));
  }
  if (header.text("content_hash") != database.content_hash()) {
    refuse(file, "content_hash",
           fmt::format("an index of {} ({})", database.path().string(), database.content_hash()),
           header.text("content_hash"));
  }
}

LshOptions read_options(const JsonFields& header, const std::string& file) {
  LshOptions options;
  options.tables = header.natural("tables");
  options.hashes = header.natural("hashes");
  options.probes = header.natural("probes");
  options.width = number(header, "width", file);
  const std::string seed = header.text("seed");
  if (seed.empty() || seed.size() > 20 || !std::ranges::all_of(seed, ::isdigit)) {
    refuse(file, "seed", "a whole number", seed);
  }
  options.seed = std::strtoull(seed.c_str(), nullptr, 10);
  check_lsh_options(options);
  return options;
}

// Whatever the rows are, looking them up must stay inside the table and the database.
void check_table(const LshTable& table, std::size_t rows, const std::string& file) {
  const bool good = std::ranges::is_sorted(table.keys) && std::ranges::is_sorted(table.starts) &&
                    table.starts.back() <= table.rows.size() &&
                    std::ranges::all_of(table.rows, [&](std::uint32_t row) { return row < rows; });
  if (!good) refuse(file, "table", "rows of the database by ascending key", "something else");
}

std::vector<LshTable> read_tables(const json& key_counts, const Database& database, Reader& reader,
                                  const std::string& file) {
  std::vector<LshTable> tables;
  for (const json& count : key_counts) {
    if (!count.is_number_unsigned() || count.get<std::uint64_t>() > database.rows()) {
      refuse(file, "keys", fmt::format("at most {}", database.rows()), count.dump());
    }
    const auto keys = count.get<std::size_t>();
    LshTable table;
    table.keys = reader.values<std::uint64_t>(keys);
    table.starts = reader.values<std::uint32_t>(keys + 1);
    table.rows = reader.values<std::uint32_t>(database.rows());
    check_table(table, database.rows(), file);
    tables.push_back(std::move(table));
  }
  return tables;
}

// The bytes before the checksum, once that is right.
std::string_view checked_bytes(const MappedFile& mapped, const std::string& file) {
  const std::string_view bytes(reinterpret_cast<const char*>(mapped.bytes().data()),
                               mapped.bytes().size());
  if (bytes.size() < sizeof(std::uint64_t) + kHashDigits) {
    refuse(file, "data", "an index", fmt::format("{} bytes", bytes.size()));
  }
  const std::string_view checked = bytes.substr(0, bytes.size() - kHashDigits);
  const std::string expected(bytes.substr(checked.size())), found = hash_hex(checked);
  if (found != expected) refuse(file, "data", "checksum " + expected, found);
  return checked;
}

}  // namespace

void save_lsh_index(const std::filesystem::path& path, const Database& database,
                    const LshOptions& options) {
  write_text(path, index_bytes(build_lsh_index(database, options), database));
}

LshIndex load_lsh_index(const std::filesystem::path& path, const Database& database) {
  const std::string file = path.string();
  const MappedFile mapped(path);
  Reader reader(checked_bytes(mapped, file), file);
  const std::size_t length = reader.values<std::uint64_t>(1)[0];
  if (length > kMaxHeader) refuse(file, "header", "less than 1 MB", std::to_string(length));
  const json root = parse_strict_json(reader.take(length), file, "header");
  const JsonFields header(root, file, "header");
  check_belongs(header, database, file);
  LshIndex index{.options = read_options(header, file),
                 .cell = number(header, "cell", file),
                 .tables = read_tables(header.at("keys"), database, reader, file)};
  // Within what check_lsh_options and a descriptor's size allow, so that cells can be numbered.
  if (index.cell < 1e-3 || index.cell > 1e9)
    refuse(file, "cell", "0.001 to 1e9", std::to_string(index.cell));
  if (std::ssize(index.tables) != index.options.tables || reader.left() > 0) {
    refuse(file, "tables", std::to_string(index.options.tables), "a file of other tables");
  }
  return index;
}

}  // namespace graspdb
