// SPDX-License-Identifier: MIT
#include "graspdb/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "graspdb/core/error.h"

namespace graspdb {

namespace fs = std::filesystem;

namespace {

// What temporary files beside `path` are called that this machine's processes write.
std::string aside_start(const fs::path& path) {
  char host[HOST_NAME_MAX + 1] = {};
  if (::gethostname(host, HOST_NAME_MAX) != 0) host[0] = '\0';
  return fmt::format("{}.{}.", path.string(), host);
}

// Where a file of that name is written: what a link leads to, not the link. Only a file is
// replaced: the one that is renamed would take the place of a device, too.
fs::path place_of(const fs::path& path) {
  std::error_code unknown;  // open() reports what matters
  fs::path place = fs::is_symlink(path, unknown) ? fs::weakly_canonical(path, unknown) : path;
  const fs::file_status status = fs::status(place, unknown);
  if (!fs::exists(status) || fs::is_regular_file(status)) return place;
  throw Error({.file = path.string(),
               .expected = "a file to write",
               .found = fs::is_directory(status) ? "a folder" : "a device or a pipe"});
}

// How every pointer begins: https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md
constexpr std::string_view kPointerStart = "version https://git-lfs.github.com/spec";

void refuse_pointer(const fs::path& path, std::string_view text) {
  if (!text.starts_with(kPointerStart)) return;
  throw Error({.file = path.string(),
               .expected = "the file itself",
               .found = "a Git LFS pointer to it; `git lfs pull` fetches the file"});
}

}  // namespace

std::string read_text(const fs::path& path) {
  const auto refuse = [&](const std::string& found) -> Error {
    return Error({.file = path.string(), .expected = "a readable file", .found = found});
  };
  std::error_code unknown;  // such as a name that no file can have
  if (fs::is_directory(path, unknown)) throw refuse("a folder");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw refuse(errno == ENOENT ? "none" : std::strerror(errno));
  if (!fs::is_regular_file(path, unknown)) throw refuse("something else");
  std::ostringstream text;
  const bool is_empty = stream.peek() == std::ifstream::traits_type::eof();
  if (!is_empty && !(text << stream.rdbuf())) throw refuse(std::strerror(errno));
  std::string bytes = std::move(text).str();
  refuse_pointer(path, bytes);
  return bytes;
}

void require_fetched(const fs::path& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown)) return;  // reading a pipe would wait
  std::string start(kPointerStart.size(), '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  refuse_pointer(path, start);
}

FileAside::FileAside(fs::path path) : path_(std::move(path)), place_(place_of(path_)) {
  aside_ = fmt::format("{}{}.tmp", aside_start(place_), ::getpid());
  if (place_.has_parent_path()) {
    std::error_code fault;
    fs::create_directories(place_.parent_path(), fault);
    if (fault) throw Error(cannot("create its folder", fault.message()));
  }
  descriptor_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail("create");
}

FileAside::~FileAside() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(aside_.c_str());
}

std::string FileAside::cannot(const char* doing, const std::string& why) const {
  return fmt::format("{}: cannot {}: {}", path_.string(), doing, why);
}

void FileAside::fail(const char* doing) const {
  throw Error(cannot(doing, std::strerror(errno)));
}

void FileAside::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void FileAside::write(std::string_view text) {
  write(std::as_bytes(std::span(text.data(), text.size())));
}

void FileAside::commit() {
  if (::fsync(descriptor_) != 0) fail("flush");
  if (::rename(aside_.c_str(), place_.c_str()) != 0) fail("rename into place");
  ::close(descriptor_);
  descriptor_ = -1;
}

void remove_leftovers(const fs::path& path) {
  const std::string start = aside_start(path.filename()), end = ".tmp";
  std::error_code ignored;  // no folder, no leftovers
  for (const auto& entry : fs::directory_iterator(fs::absolute(path).parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(end)) continue;
    const pid_t writer = std::atoi(name.c_str() + start.size());
    if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
  }
}

void write_text(const fs::path& path, std::string_view text) {
  FileAside file(path);
  file.write(text);
  file.commit();
}

}  // namespace graspdb
