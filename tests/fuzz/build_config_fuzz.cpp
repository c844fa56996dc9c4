// SPDX-License-Identifier: MIT
// Whatever a build configuration holds, as TOML, as JSON or as a database stores it (that JSON,
// which a .json file is too): it can be checked and written, or an Error refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/generator/build_config.h"
#include "memory_file.h"
#include "named_file.h"

namespace graspdb {
namespace {

void expect_config_or_refused(const std::filesystem::path& file) {
  try {
    const BuildConfig config = load_config(file);
    if (config_to_json(config).empty()) std::abort();
    check_config(config);
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = graspdb::testing::text_of(data, size);
  for (const char* name : {"config.toml", "config.json"}) {
    graspdb::expect_config_or_refused(graspdb::testing::named_file(name, bytes));
  }
  return 0;
}
