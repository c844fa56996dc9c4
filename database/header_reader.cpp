// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <set>

#include "graspdb/core/hash.h"
#include "graspdb/core/json/strict_json.h"
#include "header.h"
#include "refuse.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxHeaderBytes = 100'000'000;  // as in the safetensors library

std::string zeroed_hash(std::string header) {
  return header.replace(kHashPosition, kHashDigits, kHashDigits, '0');
}

std::string_view header_text(std::span<const std::byte> bytes, const std::string& file) {
  std::uint64_t length = 0;
  if (bytes.size() < kPrefixBytes) {
    refuse(file, "header", "8 bytes of length", fmt::format("{} bytes", bytes.size()));
  }
  std::memcpy(&length, bytes.data(), kPrefixBytes);
  if (length > kMaxHeaderBytes || length > bytes.size() - kPrefixBytes) {
    refuse(file, "header", "a graspdb database",
           fmt::format("a header of {} bytes in a file of {}", length, bytes.size()));
  }
  return {reinterpret_cast<const char*>(bytes.data()) + kPrefixBytes, length};
}

// Nothing of the header is believed before this has passed. Gives the version.
std::string check_seal(std::string_view header, const std::string& file) {
  if (!header.starts_with(kSignature)) {
    refuse(file, "header", "a graspdb database", "another kind of file");
  }
  const std::string_view rest = header.substr(kSignature.size());
  const std::string version(rest.substr(0, rest.find('"')));
  if (version != kPlainVersion && version != kEmbeddingVersion) {
    refuse(file, "format_version", "1 or 2", version.substr(0, 20));
  }
  if (!rest.substr(version.size()).starts_with(kHashKey) ||
      header.size() < kHashPosition + kHashDigits) {
    refuse(file, "header_hash", "the third entry of __metadata__", "none");
  }
  const std::string expected(header.substr(kHashPosition, kHashDigits));
  const std::string found = hash_hex(zeroed_hash(std::string(header)));
  if (found != expected) refuse(file, "header", "checksum " + expected, found);
  return version;
}

// The number of rows, which every column must then agree with.
std::size_t read_rows(const json& root, const std::string& file) {
  const json& shape =
      JsonFields(JsonFields(root, file, "header").at("label"), file, "label").at("shape");
  if (!shape.is_array() || shape.empty() || !shape[0].is_number_unsigned() ||
      shape[0].get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    refuse(file, "label.shape", "[rows, 31] with fewer than 2^32 rows", shape.dump());
  }
  return shape[0].get<std::size_t>();
}

// The length of the embeddings, which the header states as their shape.
std::size_t read_embedding_bytes(const json& root, const std::string& file) {
  const JsonFields entry(JsonFields(root, file, "header").at("embedding"), file, "embedding");
  const json& shape = entry.at("shape");
  const json& bytes = shape.is_array() && shape.size() == 2 ? shape[1] : shape;
  if (!bytes.is_number_unsigned() || !is_embedding_size(bytes.get<std::size_t>())) {
    refuse(file, "embedding.shape", "[rows, 64] or [rows, 128]", shape.dump());
  }
  return bytes.get<std::size_t>();
}

void check_columns(const json& root, const Columns& columns, std::size_t rows,
                   const std::string& file) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string name(columns[i].name);
    const json& found = JsonFields(root, file, "header").at(name);
    const json expected = json::parse(columns.json(i, rows));
    if (found != expected) refuse(file, name, expected.dump(), found.dump());
  }
  if (root.size() != columns.size() + 1) {
    refuse(file, "header", fmt::format("{} columns", columns.size()),
           fmt::format("{}", root.size() - 1));
  }
}

void check_size(std::size_t header_size, std::size_t data_size, std::size_t rows, std::size_t size,
                const std::string& file) {
  const std::size_t start = kPrefixBytes + header_size;
  if (start % kAlignment != 0) {
    refuse(file, "header", "data aligned to 64 bytes", fmt::format("data at {}", start));
  }
  const std::size_t expected = start + data_size;
  if (size != expected) {
    refuse(file, "data", fmt::format("a file of {} bytes for {} rows", expected, rows),
           fmt::format("{} bytes", size));
  }
}

DatabaseInfo read_info(const JsonFields& metadata, const std::string& file) {
  DatabaseInfo info;
  for (const json& entry : metadata.inner_array("grasps")) {
    const JsonFields grasp(entry, file, "grasps");
    info.grasps.push_back({grasp.natural("id"), grasp.text("name")});
  }
  for (const json& entry : metadata.inner_array("hands")) {
    const JsonFields hand(entry, file, "hands");
    info.hands.push_back({hand.text("name"), skeleton_from_json(hand.at("skeleton").dump(), file)});
  }
  for (const json& entry : metadata.inner_array("variants")) {
    if (!entry.is_string()) refuse(file, "variants", "texts", entry.dump());
    info.variants.push_back(entry.get<std::string>());
  }
  info.steps = metadata.inner_natural("steps");
  info.views = metadata.inner_natural("views");
  info.camera_distance = metadata.inner_number("camera_distance_m");
  info.view_rule = metadata.text("view_rule");
  info.hog = metadata.text("hog");
  info.config = metadata.text("config");
  info.tool = metadata.text("tool");
  info.processor = metadata.text("processor");
  if (metadata.has("data_card")) {
    metadata.inner("data_card");  // JSON, or refused
    info.data_card = metadata.text("data_card");
  }
  return info;
}

void check_hash(const JsonFields& metadata, const std::string& key, const std::string& expected,
                const std::string& file) {
  const std::string found = metadata.text(key);
  if (found != expected) refuse(file, key, expected, found);
}

void check_range(const std::string& file, const std::string& key, long long low, long long high,
                 long long found) {
  if (found >= low && found <= high) return;
  refuse(file, key, fmt::format("{} to {}", low, high), std::to_string(found));
}

}  // namespace

void check_info(const DatabaseInfo& info, const std::string& file) {
  std::set<int> ids;
  for (const GraspEntry& grasp : info.grasps) {
    check_range(file, "grasps.id", 1, 65535, grasp.id);
    if (!ids.insert(grasp.id).second) {
      refuse(file, "grasps.id", "each once", fmt::format("{} twice", grasp.id));
    }
  }
  if (info.embedding_bytes != 0 && !is_embedding_size(info.embedding_bytes)) {
    refuse(file, "embedding", "64 or 128 bytes", fmt::format("{}", info.embedding_bytes));
  }
  check_range(file, "hands", 0, 256, std::ssize(info.hands));
  check_range(file, "variants", 0, 256, std::ssize(info.variants));
  check_range(file, "steps", 1, 255, info.steps);
  check_range(file, "views", 1, std::numeric_limits<int>::max(), info.views);
  if (!(info.camera_distance > 0 && info.camera_distance < 1e6)) {
    refuse(file, "camera_distance_m", "metres", fmt::format("{}", info.camera_distance));
  }
}

Header read_header(std::span<const std::byte> bytes, const std::string& file) {
  const std::string_view text = header_text(bytes, file);
  const std::string version = check_seal(text, file);
  const json root = parse_strict_json(text, file, "header");
  Header header;
  header.rows = read_rows(root, file);
  const bool has_embeddings = version == kEmbeddingVersion;
  const Columns columns(has_embeddings ? read_embedding_bytes(root, file) : 0);
  check_columns(root, columns, header.rows, file);
  check_size(text.size(), columns.offset(columns.size(), header.rows), header.rows, bytes.size(),
             file);
  const JsonFields metadata(JsonFields(root, file, "header").at("__metadata__"), file,
                            "__metadata__");
  header.info = read_info(metadata, file);
  header.info.embedding_bytes = columns[kEmbedding].width;
  if (has_embeddings) {
    header.info.descriptor = metadata.text("descriptor");
    header.info.weights = metadata.text("weights_hash");
  }
  check_info(header.info, file);
  const json hashes = metadata.inner("column_hashes");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    header.column_hashes.push_back(
        JsonFields(hashes, file, "column_hashes").text(std::string(columns[i].name)));
  }
  check_hash(metadata, "content_hash", content_hash(header.column_hashes), file);
  check_hash(metadata, "config_hash", hash_hex(header.info.config), file);
  return header;
}

std::span<const std::byte> data_bytes(std::span<const std::byte> bytes) {
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), kPrefixBytes);
  return bytes.subspan(kPrefixBytes + length);
}

}  // namespace graspdb
