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

}  // namespace

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  std::error_code unknown;  // such as a name that no file can have
  const bool is_file = fs::is_regular_file(path, unknown);
  if (!is_file || !stream || !(text << stream.rdbuf())) {
    if (is_file && fs::file_size(path) == 0) return {};
    throw Error({.file = path.string(),
                 .expected = "a readable file",
                 .found = fs::exists(path, unknown) ? "something else" : "none"});
  }
  return text.str();
}

FileAside::FileAside(fs::path path)
    : path_(std::move(path)), aside_(fmt::format("{}{}.tmp", aside_start(path_), ::getpid())) {
  if (path_.has_parent_path()) {
    std::error_code ignored;  // open() reports what matters
    fs::create_directories(path_.parent_path(), ignored);
  }
  descriptor_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail("create");
}

FileAside::~FileAside() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(aside_.c_str());
}

void FileAside::fail(const char* doing) const {
  throw Error(fmt::format("{}: cannot {}: {}", path_.string(), doing, std::strerror(errno)));
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
  if (::rename(aside_.c_str(), path_.c_str()) != 0) fail("rename into place");
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
