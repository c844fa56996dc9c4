// SPDX-License-Identifier: MIT
// The container of a .glb file: a chunk of JSON and one of binary data (the glTF 2.0 specification,
// "GLB File Format Specification").
#pragma once

#include <string>
#include <string_view>

namespace graspdb {

struct GlbParts {
  std::string_view json, binary;  // parts of the bytes that were read; `binary` may be empty
};

// Throws Error, with `file` for its name, for what is no such container or says other lengths than
// it has.
GlbParts glb_parts(std::string_view bytes, const std::string& file);

// The file that holds both. The JSON is padded with spaces; the length of `binary` is a multiple of
// 4.
std::string glb_file(std::string json, std::string_view binary);

}  // namespace graspdb
