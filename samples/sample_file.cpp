// SPDX-License-Identifier: MIT
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/core/json/safetensors.h"
#include "graspdb/samples/samples.h"

namespace graspdb {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kWrittenAtOnce = 1 << 20;  // bytes: they stay in a cache

template <typename T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

// Column by column, as Eigen keeps them: points one after the other.
template <typename Matrix>
void put_floats(std::string& bytes, const Matrix& matrix) {
  for (const double value : matrix.reshaped()) put(bytes, static_cast<float>(value));
}

using Put = std::function<void(const Sample&, std::string&)>;

Put plane(CropPlane HandCrop::*member) {
  return [member](const Sample& s, std::string& to) { put(to, s.crop.*member); };
}

// A tensor of the file, with the shape of one sample's part and how that becomes bytes.
struct Field {
  TensorInfo info;
  Put put_sample;
};

Field codes(std::size_t bytes) {
  return {{"embedding", "U8", {bytes}}, [](const Sample& s, std::string& to) {
            to.append(s.embedding.begin(), s.embedding.end());
          }};
}

Field hogs() {
  return {{"hog", "U8", {kDescriptorSize}},
          [](const Sample& s, std::string& to) { to.append(s.hog->begin(), s.hog->end()); }};
}

std::vector<Field> fields() {
  using S = const Sample&;
  using B = std::string&;
  const auto floats = [](const char* name, std::vector<std::size_t> shape, const Put& put_sample) {
    return Field{{name, "F32", std::move(shape)}, put_sample};
  };
  const auto number = [](const char* name, std::function<std::uint64_t(S)> of) {
    return Field{{name, "I32", {}}, [of](S s, B to) { put(to, static_cast<std::int32_t>(of(s))); }};
  };
  const auto picture = [](const char* name, CropPlane HandCrop::*member) {
    return Field{{name, "U8", {kCropSide, kCropSide}}, plane(member)};
  };
  return {
      floats("rotation", {3, 3}, [](S s, B to) { put_floats(to, s.crop_from_hand.transpose()); }),
      floats("angles", {kAngleCount}, [](S s, B to) { put_floats(to, s.angles); }),
      floats("joints", {kKeypointCount, 3}, [](S s, B to) { put_floats(to, s.joints); }),
      floats("hand_length", {}, [](S s, B to) { put(to, static_cast<float>(s.hand_length)); }),
      floats("hidden", {}, [](S s, B to) { put(to, static_cast<float>(s.hidden)); }),
      number("grasp", [](S s) { return static_cast<std::uint64_t>(s.grasp); }),
      number("hand", [](S s) { return s.hand; }),
      number("sequence", [](S s) { return std::uint64_t{s.sequence}; }),
      number("held", [](S s) { return std::uint64_t{s.held}; }),
      picture("gray", &HandCrop::gray),
      picture("mask", &HandCrop::mask),
      picture("scene", &HandCrop::scene)};
}

void write(const std::filesystem::path& path, std::span<const Sample> samples,
           std::map<std::string, std::string> metadata) {
  std::vector<Field> all = fields();
  const std::size_t code = samples.empty() ? 0 : samples.front().embedding.size();
  if (code > 0) all.push_back(codes(code));
  if (!samples.empty() && samples.front().hog) all.push_back(hogs());
  std::vector<TensorInfo> tensors;
  for (const Field& field : all) {
    tensors.push_back(field.info);
    tensors.back().shape.insert(tensors.back().shape.begin(), samples.size());
  }
  metadata.insert({{"format", "graspdb samples"}, {"format_version", "2"}});
  FileAside file(path);
  file.write(safetensors_header(tensors, metadata));
  for (const Field& field : all) {
    std::string bytes;
    for (const Sample& sample : samples) {
      field.put_sample(sample, bytes);
      if (bytes.size() < kWrittenAtOnce) continue;
      file.write(bytes);
      bytes.clear();
    }
    file.write(bytes);
  }
  file.commit();
}

}  // namespace

void write_samples(const std::filesystem::path& file, std::span<const Sample> samples,
                   const SampleConfig& config, std::uint64_t first,
                   std::span<const SampleAsset> assets) {
  ordered_json seen = ordered_json::array();
  for (const SampleAsset& asset : assets) {
    seen.push_back({{"name", asset.name}, {"hash", asset.hash}});
  }
  write(file, samples,
        {{"config", sample_config_json(config)},
         {"first", std::to_string(first)},
         {"assets", seen.dump()}});
}

void write_samples(const std::filesystem::path& file, const SequenceSamples& sequences) {
  write(file, sequences.samples, {{"sequences", ordered_json(sequences.names).dump()}});
}

}  // namespace graspdb
