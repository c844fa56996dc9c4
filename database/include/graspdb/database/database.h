// SPDX-License-Identifier: MIT
// The packed database file: a safetensors file of columns (docs/format.md), mapped and not read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "graspdb/core/descriptor.h"
#include "graspdb/hand/label.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

struct GraspEntry {
  int id = 0;
  std::string name;
};
struct HandEntry {
  std::string name;
  Skeleton skeleton;
};

// What a database says of itself; stored in the file's __metadata__. Ids of grasps are 1..65535,
// each once; steps at most 255; hands and variants at most 256. All texts are UTF-8.
struct DatabaseInfo {
  std::vector<GraspEntry> grasps;
  std::vector<HandEntry> hands;
  std::vector<std::string> variants;  // "held", "free"
  int steps = 0;
  int views = 0;
  double camera_distance = 0;       // from the camera to the palm centre, metres
  std::string view_rule;            // e.g. "super-fibonacci"
  std::string hog;                  // the name of the HOG's options
  std::size_t embedding_bytes = 0;  // of a learned descriptor's code; 0: there are none
  std::string descriptor;           // its name
  std::string weights;              // the hash of its file of weights
  std::string config;               // the whole configuration, JSON
  std::string tool;                 // e.g. "graspdb 0.1.0"
  std::string processor;  // the kind that made the rows, where that can change a bit; else empty
  // What the database is and under which licences, JSON (docs/data-card.md); may be empty, as it is
  // in files from before there was one.
  std::string data_card = {};
};

// "" when there is none of that id.
std::string grasp_name(const DatabaseInfo& info, int id);

// One row before it is packed.
struct Row {
  Label label{};
  BoxTangents box;  // of the visible hand
  std::uint32_t view = 0;
  std::uint16_t grasp = 0;  // the grasp's id
  Descriptor hog{};
  Embedding embedding;       // empty in a database without
  std::uint8_t step = 0;     // 1..steps
  std::uint8_t hand = 0;     // index into info.hands
  std::uint8_t variant = 0;  // index into info.variants
};

// Writes all rows aside and renames; the bytes depend on nothing but info and rows. The rows fit
// the info: labels finite, grasps known, ordinals in range. Throws Error (a full disk, an
// unwritable place, an info that contradicts itself); nothing is left then.
void write_database(const std::filesystem::path& path, const DatabaseInfo& info,
                    std::span<const Row> rows);

// A database of one hand and one variant, and which hand and variant of the whole they are.
struct DatabasePart {
  std::filesystem::path file;
  std::uint8_t hand = 0;
  std::uint8_t variant = 0;
};

// Writes the rows of all parts, one part after another, as one database, aside and renamed; no more
// than a piece of a column is held in memory. Throws Error when a part is no database or does not
// belong to `info`: another hand, grasp, descriptor, processor, number of views... The content of
// the parts is taken as it is: see verify_database. `heed` is called again and again; what it
// throws ends the work and leaves no file.
void join_databases(const std::filesystem::path& path, const DatabaseInfo& info,
                    std::span<const DatabasePart> parts, const std::function<void()>& heed = {});

// A mapped database. Opening checks header and sizes, not the content: see verify. Cheap to move;
// reading is thread-safe; spans live as long as the database.
class Database {
 public:
  // Throws Error when the file is no database or its header, its size or its version is wrong.
  static Database open(const std::filesystem::path& path);
  ~Database();
  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;

  std::size_t rows() const;
  const DatabaseInfo& info() const;
  const std::filesystem::path& path() const;
  const std::string& content_hash() const;  // of all columns, as the header states them

  LabelView label(std::size_t row) const;
  BoxTangents box(std::size_t row) const;
  std::span<const std::uint8_t, kDescriptorSize> hog(std::size_t row) const;
  DescriptorTable hogs() const;
  bool has_embeddings() const;
  DescriptorTable descriptors()
      const;  // what is searched: embeddings, or HOGs where there are none
  std::uint32_t view(std::size_t row) const;
  std::uint16_t grasp(std::size_t row) const;  // id
  std::uint8_t step(std::size_t row) const;
  std::uint8_t hand(std::size_t row) const;
  std::uint8_t variant(std::size_t row) const;

 private:
  struct Mapping;
  explicit Database(std::unique_ptr<Mapping> mapping);
  std::unique_ptr<Mapping> mapping_;
};

// Checks the content too: header and column checksums, labels finite, ordinals in range. Throws
// Error naming the file and the column.
void verify_database(const std::filesystem::path& path);

}  // namespace graspdb
