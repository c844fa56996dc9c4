// SPDX-License-Identifier: MIT
#include "graspdb/core/folder.h"

#include <fnmatch.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

bool matches(const std::string& pattern, const fs::path& path) {
  return ::fnmatch(pattern.c_str(), path.c_str(), FNM_PATHNAME) == 0;
}

// What killed writers leave beside a file.
bool is_leftover(const std::string& pattern, const fs::path& path) {
  return matches(pattern + ".*.tmp", path);
}

bool is_of(const FolderContent& content, const fs::path& inside) {
  const auto is_like = [&](const std::string& pattern) {
    return matches(pattern, inside) || is_leftover(pattern, inside);
  };
  return is_like(content.marker) || std::ranges::any_of(content.files, is_like);
}

[[noreturn]] void refuse(const fs::path& folder, const FolderContent& content,
                         const fs::path& found) {
  throw Error({folder.string(), "", "a new folder, or one that holds " + content.kind + " only",
               found.string()});
}

// All files below the folder, as paths in it. Links are not followed.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_symlink() || !entry.is_directory())
      files.push_back(entry.path().lexically_relative(folder));
  }
  std::ranges::sort(files);
  return files;
}

void require_own(const fs::path& folder, const FolderContent& content) {
  const std::vector<fs::path> files = files_in(folder);
  for (const fs::path& file : files) {
    if (!is_of(content, file)) refuse(folder, content, file);
  }
  if (fs::exists(folder / content.marker)) return;
  // Names alone do not tell whose pictures they are.
  for (const fs::path& file : files) {
    if (!is_leftover(content.marker, file))
      refuse(folder, content, file.string() + ", but no " + content.marker);
  }
}

}  // namespace

void claim_folder(const fs::path& folder, const FolderContent& content) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault || !fs::is_directory(folder, fault)) {
    throw Error({folder.string(), "", "a folder", fault ? fault.message() : "a file"});
  }
  try {
    require_own(folder, content);
  } catch (const fs::filesystem_error& error) {
    throw Error({folder.string(), "", "a readable folder", error.code().message()});
  }
  if (!fs::exists(folder / content.marker)) write_text(folder / content.marker, "");
}

void renew_folder(const fs::path& folder, const FolderContent& content) {
  claim_folder(folder, content);
  std::vector<fs::path> earlier;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() != content.marker) earlier.push_back(entry.path());
  }
  for (const fs::path& path : earlier) fs::remove_all(path);
}

std::string digits(int count) {
  std::string pattern;
  for (int i = 0; i < count; ++i) pattern += "[0-9]";
  return pattern;
}

}  // namespace graspdb
