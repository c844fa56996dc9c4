// SPDX-License-Identifier: MIT
#include <bit>
#include <nlohmann/json.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/samples/samples.h"

namespace graspdb {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "tensors are written as they lie");

// One tensor of the file and how a sample's part of it becomes bytes.
struct Tensor {
  const char* name;
  const char* dtype;
  std::vector<std::size_t> shape;  // of one sample
  std::size_t bytes;               // of one sample
  std::function<void(const Sample&, std::string&)> append;
};

template <typename T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

// Column by column, as Eigen keeps them: of points one after the other.
template <typename Matrix>
void put_floats(std::string& bytes, const Matrix& matrix) {
  for (const double value : matrix.reshaped()) put(bytes, static_cast<float>(value));
}

Tensor plane(const char* name, CropPlane HandCrop::*member) {
  return {name,
          "U8",
          {kCropSide, kCropSide},
          kCropPixels,
          [member](const Sample& s, std::string& bytes) { put(bytes, s.crop.*member); }};
}

std::vector<Tensor> tensors() {
  return {
      {"rotation",
       "F32",
       {3, 3},
       36,
       [](const Sample& s, std::string& b) { put_floats(b, s.crop_from_hand.transpose()); }},
      {"angles",
       "F32",
       {kAngleCount},
       4 * kAngleCount,
       [](const Sample& s, std::string& b) { put_floats(b, s.angles); }},
      {"joints",
       "F32",
       {kKeypointCount, 3},
       12 * kKeypointCount,
       [](const Sample& s, std::string& b) { put_floats(b, s.joints); }},
      {"hand_length",
       "F32",
       {},
       4,
       [](const Sample& s, std::string& b) { put(b, static_cast<float>(s.hand_length)); }},
      {"hidden",
       "F32",
       {},
       4,
       [](const Sample& s, std::string& b) { put(b, static_cast<float>(s.hidden)); }},
      {"grasp",
       "I32",
       {},
       4,
       [](const Sample& s, std::string& b) { put(b, std::int32_t{s.grasp}); }},
      {"hand",
       "I32",
       {},
       4,
       [](const Sample& s, std::string& b) { put(b, static_cast<std::int32_t>(s.hand)); }},
      {"sequence",
       "I32",
       {},
       4,
       [](const Sample& s, std::string& b) { put(b, static_cast<std::int32_t>(s.sequence)); }},
      {"held",
       "U8",
       {},
       1,
       [](const Sample& s, std::string& b) { put(b, static_cast<std::uint8_t>(s.held)); }},
      plane("gray", &HandCrop::gray),
      plane("mask", &HandCrop::mask),
      plane("scene", &HandCrop::scene),
  };
}

std::string header(const std::vector<Tensor>& all, std::size_t count, ordered_json metadata) {
  metadata["format"] = "graspdb samples";
  metadata["format_version"] = "1";
  ordered_json root{{"__metadata__", metadata}};
  std::size_t offset = 0;
  for (const Tensor& tensor : all) {
    std::vector<std::size_t> shape = {count};
    shape.insert(shape.end(), tensor.shape.begin(), tensor.shape.end());
    root[tensor.name] = {{"dtype", tensor.dtype},
                         {"shape", shape},
                         {"data_offsets", {offset, offset + tensor.bytes * count}}};
    offset += tensor.bytes * count;
  }
  std::string text = root.dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');
  std::string bytes;
  put(bytes, std::uint64_t{text.size()});
  return bytes + text;
}

void write(const std::filesystem::path& path, std::span<const Sample> samples,
           const ordered_json& metadata) {
  const std::vector<Tensor> all = tensors();
  FileAside file(path);
  file.write(header(all, samples.size(), metadata));
  for (const Tensor& tensor : all) {
    std::string bytes;
    bytes.reserve(tensor.bytes * samples.size());
    for (const Sample& sample : samples) tensor.append(sample, bytes);
    file.write(bytes);
  }
  file.commit();
}

}  // namespace

void write_samples(const std::filesystem::path& file, std::span<const Sample> samples,
                   const SampleConfig& config, std::uint64_t first,
                   std::span<const SampleAsset> assets) {
  ordered_json seen = ordered_json::array();
  for (const SampleAsset& asset : assets)
    seen.push_back({{"name", asset.name}, {"hash", asset.hash}});
  write(file, samples,
        {{"config", sample_config_json(config)},
         {"first", std::to_string(first)},
         {"assets", seen.dump()}});
}

void write_samples(const std::filesystem::path& file, const SequenceSamples& sequences) {
  write(file, sequences.samples, {{"sequences", ordered_json(sequences.names).dump()}});
}

}  // namespace graspdb
