// SPDX-License-Identifier: MIT
// Small safetensors files: https://github.com/huggingface/safetensors. (A database is one, too, but
// is mapped, sealed and written column by column: database/header.h.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace graspdb {

// A tensor's entry in the header; its numbers lie row by row.
struct TensorInfo {
  std::string name;
  std::string dtype;  // as safetensors calls it: "U8", "I8", "I32", "F32"
  std::vector<std::size_t> shape;
  bool operator==(const TensorInfo&) const = default;
};

// The length of the header and the header. The tensors' bytes follow in the same order.
std::string safetensors_header(std::span<const TensorInfo> tensors,
                               const std::map<std::string, std::string>& metadata);

// A file that was read whole.
class Safetensors {
 public:
  // Throws Error for what cannot be read, is larger than `most_bytes` or is no such file: tensors
  // must fill the data one after the other, in the header's order or any other.
  static Safetensors load(const std::filesystem::path& file, std::size_t most_bytes);
  // `file` stands for it in messages.
  static Safetensors parse(std::string bytes, const std::string& file);

  const std::string& file() const { return file_; }
  const std::string& bytes() const { return bytes_; }  // all of it
  // Throws Error for a key that is not there.
  const std::string& metadata(const std::string& key) const;
  // Throws Error for a tensor that is not there or not of this type and shape; a length of 0 stands
  // for any.
  template <typename T>
  std::vector<T> tensor(const TensorInfo& expected) const;
  const std::vector<std::size_t>& shape(const std::string& name) const;
  std::size_t tensor_count() const { return tensors_.size(); }

 private:
  struct Place {
    TensorInfo info;
    std::size_t begin = 0, end = 0;  // in bytes_
  };
  const Place& place(const std::string& name) const;
  std::span<const char> bytes_of(const TensorInfo& expected) const;

  std::string file_, bytes_;
  std::map<std::string, std::string> metadata_;
  std::map<std::string, Place> tensors_;
};

// Of one number of that type; 0 for a type that is none of those above.
std::size_t dtype_bytes(const std::string& dtype);

template <typename T>
std::vector<T> Safetensors::tensor(const TensorInfo& expected) const {
  const std::span<const char> bytes = bytes_of(expected);
  std::vector<T> numbers(bytes.size() / sizeof(T));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(numbers.data()));
  return numbers;
}

}  // namespace graspdb
