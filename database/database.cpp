// SPDX-License-Identifier: MIT
#include "graspdb/database/database.h"

#include "graspdb/core/error.h"
#include "header.h"
#include "mapped_file.h"

namespace graspdb {

struct Database::Mapping {
  explicit Mapping(const std::filesystem::path& from)
      : path(from), file(from), header(read_header(file.bytes(), from.string())) {}

  // One row of a column, as the type that it is stored as.
  template <typename T>
  const T* at(ColumnIndex column, std::size_t row) const {
    GRASPDB_CHECK(row < header.rows);
    return first<T>(column) + row * std::max<std::size_t>(columns[column].width, 1);
  }
  template <typename T>
  const T* first(ColumnIndex column) const {
    return reinterpret_cast<const T*>(data.data() + columns.offset(column, header.rows));
  }

  std::filesystem::path path;
  MappedFile file;
  Header header;
  Columns columns = columns_of(header.info);
  std::span<const std::byte> data = data_bytes(file.bytes());
  std::string content = graspdb::content_hash(header.column_hashes);
};

Database::Database(std::unique_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}
Database::~Database() = default;
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;

Database Database::open(const std::filesystem::path& path) {
  return Database(std::make_unique<Mapping>(path));
}

std::size_t Database::rows() const {
  return mapping_->header.rows;
}
const DatabaseInfo& Database::info() const {
  return mapping_->header.info;
}
const std::filesystem::path& Database::path() const {
  return mapping_->path;
}
const std::string& Database::content_hash() const {
  return mapping_->content;
}

std::string grasp_name(const DatabaseInfo& info, int id) {
  const auto found = std::ranges::find(info.grasps, id, &GraspEntry::id);
  return found == info.grasps.end() ? "" : found->name;
}

LabelView Database::label(std::size_t row) const {
  return std::span<const float, kLabelSize>(mapping_->at<float>(kLabel, row), kLabelSize);
}
BoxTangents Database::box(std::size_t row) const {
  const float* values = mapping_->at<float>(kBox, row);
  return {values[0], values[1], values[2], values[3]};
}
std::span<const std::uint8_t, kDescriptorSize> Database::hog(std::size_t row) const {
  return std::span<const std::uint8_t, kDescriptorSize>(mapping_->at<std::uint8_t>(kHog, row),
                                                        kDescriptorSize);
}
DescriptorTable Database::hogs() const {
  return {{mapping_->first<std::uint8_t>(kHog), rows() * kDescriptorSize}, kDescriptorSize};
}
bool Database::has_embeddings() const {
  return info().embedding_bytes > 0;
}
DescriptorTable Database::descriptors() const {
  if (!has_embeddings()) return hogs();
  const std::size_t size = info().embedding_bytes;
  return {{mapping_->first<std::uint8_t>(kEmbedding), rows() * size}, size};
}
std::uint32_t Database::view(std::size_t row) const {
  return *mapping_->at<std::uint32_t>(kView, row);
}
std::uint16_t Database::grasp(std::size_t row) const {
  return *mapping_->at<std::uint16_t>(kGrasp, row);
}
std::uint8_t Database::step(std::size_t row) const {
  return *mapping_->at<std::uint8_t>(kStep, row);
}
std::uint8_t Database::hand(std::size_t row) const {
  return *mapping_->at<std::uint8_t>(kHand, row);
}
std::uint8_t Database::variant(std::size_t row) const {
  return *mapping_->at<std::uint8_t>(kVariant, row);
}

}  // namespace graspdb
