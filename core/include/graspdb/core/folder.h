// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace graspdb {

// The files of one kind of result, in a folder of their own.
struct FolderContent {
  std::string kind;    // "a sequence", for messages
  std::string marker;  // a file that says of a folder that it holds that kind
  // Patterns of paths in the folder, as a shell has them: "frames/[0-9].png".
  std::vector<std::string> files;
};

// Makes `folder`, or takes over one that is empty or holds an earlier result of the same kind, and
// nothing else. Marks it. Throws Error that names what else it holds, or why it cannot be written.
void claim_folder(const std::filesystem::path& folder, const FolderContent& content);

// The same; then the earlier result is removed, but for the marker.
void renew_folder(const std::filesystem::path& folder, const FolderContent& content);

// A pattern for names of so many digits.
std::string digits(int count);

}  // namespace graspdb
