// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "header.h"

namespace graspdb {

Columns::Columns(std::size_t embedding_bytes)
    : all_{{
          {"label", "F32", 4, kLabelSize, "rad"},
          {"box", "F32", 4, 4, "tangent"},
          {"view", "U32", 4, 0, "index of the view, from 0"},
          {"grasp", "U16", 2, 0, "id of the grasp"},
          {"hog", "U8", 1, kDescriptorSize, "1/255"},
          {"step", "U8", 1, 0, "1..steps"},
          {"hand", "U8", 1, 0, "index into hands, from 0"},
          {"variant", "U8", 1, 0, "index into variants, from 0"},
          {"embedding", "U8", 1, embedding_bytes, "a direction, 128 is 0"},
      }} {}

std::size_t Columns::offset(std::size_t column, std::size_t rows) const {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < column; ++i) bytes += all_[i].row_bytes();
  return bytes * rows;
}

std::string Columns::json(std::size_t column, std::size_t rows) const {
  const auto& [name, dtype, item_bytes, width, unit] = all_[column];
  const std::string shape =
      width == 0 ? fmt::format("[{}]", rows) : fmt::format("[{},{}]", rows, width);
  return fmt::format(R"({{"dtype":"{}","shape":{},"data_offsets":[{},{}]}})", dtype, shape,
                     offset(column, rows), offset(column + 1, rows));
}

Columns columns_of(const DatabaseInfo& info) {
  return Columns(info.embedding_bytes);
}

std::string_view version_of(const DatabaseInfo& info) {
  return info.embedding_bytes > 0 ? kEmbeddingVersion : kPlainVersion;
}

}  // namespace graspdb
