// SPDX-License-Identifier: MIT
#include "graspdb/pictures/export_coco.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <span>

#include "coco_text.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/parallel.h"
#include "graspdb/pictures/database_rows.h"
#include "graspdb/pictures/write_view.h"
#include "graspdb/renderer/image_io.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using Rows = std::span<const std::size_t>;

constexpr const char* kMarker = "graspdb_export.json";
constexpr const char* kAnnotations = "annotations.json";

FolderContent export_content() {
  FolderContent content{.kind = "an earlier export", .marker = kMarker, .files = {kAnnotations}};
  for (const char* folder : {"images", "masks", "hand_amodal", "object_amodal", "depth"}) {
    content.files.push_back(fmt::format("{}/{}.png", folder, digits(12)));
  }
  return content;
}

// What an earlier export left in the folder goes, so that no picture is there without its
// annotation.
void prepare_folder(const fs::path& directory, const Database& database, std::size_t rows) {
  renew_folder(directory, export_content());
  const nlohmann::json marker{{"database", database.path().string()},
                              {"content_hash", database.content_hash()},
                              {"rows", rows}};
  write_text(directory / kMarker, marker.dump(1) + "\n");
}

// The rows from the start of `rows` that are rendered by one thread from one scene.
Rows same_pose(const DatabaseRows& database, Rows rows) {
  constexpr std::size_t kMost = 216;  // few enough to keep threads busy
  std::size_t count = 1;
  while (count < std::min(rows.size(), kMost) &&
         database.key(rows[count]) == database.key(rows.front())) {
    ++count;
  }
  return rows.first(count);
}

// The items of a JSON list, a line each.
class ItemWriter {
 public:
  explicit ItemWriter(FileAside& file) : file_(file) {}

  void add(const std::string& item) {
    if (!first_) file_.write(",\n");
    file_.write(item);
    first_ = false;
  }

 private:
  FileAside& file_;
  bool first_ = true;
};

class Exporter {
 public:
  Exporter(const Database& database, const fs::path& directory, const CocoOptions& options)
      : database_(database),
        directory_(directory),
        options_(options),
        rows_(database, options.rows, options.resolution) {}

  void run() {
    prepare_folder(directory_, database_, options_.rows.size());
    FileAside file(directory_ / kAnnotations);
    file.write("{");
    file.write(coco_head(database_));
    file.write(",\n\"images\":[");
    ItemWriter images(file);
    for (const std::size_t row : options_.rows) {
      images.add(coco_image(row, rows_.resolution(), rows_.resolution()));
    }
    file.write("],\n\"annotations\":[");
    write_annotations(file);
    file.write("]}\n");
    file.commit();
  }

 private:
  using Annotations = std::vector<std::optional<std::string>>;

  void write_annotations(FileAside& file) {
    constexpr std::size_t kPiece = 8192;  // rows whose annotations are held in memory
    ItemWriter items(file);
    for (Rows left = options_.rows; !left.empty();) {
      const Rows piece = left.first(std::min(left.size(), kPiece));
      for (const auto& annotation : export_piece(piece)) {
        if (annotation) items.add(*annotation);
      }
      left = left.subspan(piece.size());
    }
  }

  Annotations export_piece(Rows piece) {
    std::vector<Rows> groups;
    for (Rows left = piece; !left.empty(); left = left.subspan(groups.back().size())) {
      groups.push_back(same_pose(rows_, left));
    }
    Annotations annotations(piece.size());
    parallel_for(groups.size(), options_.threads, [&](std::size_t i) {
      const Subject subject = rows_.subject(groups[i].front());
      for (const std::size_t& row : groups[i]) {
        annotations[static_cast<std::size_t>(&row - piece.data())] = export_row(subject, row);
      }
    });
    return annotations;
  }

  std::optional<std::string> export_row(const Subject& subject, std::size_t row) {
    const Layers layers{.depth = options_.depth, .amodal = options_.amodal};
    const LabelledView view = rows_.view(subject, row, layers);
    const std::string name = coco_file_name(row);
    write_png(directory_ / "images" / name, view.picture.shading);
    write_png(directory_ / "masks" / name, view.picture.label);
    if (options_.amodal) {
      write_png(directory_ / "hand_amodal" / name, view.picture.hand_amodal);
      write_png(directory_ / "object_amodal" / name, view.picture.object_amodal);
    }
    if (options_.depth) {
      write_png16(directory_ / "depth" / name, depth_in_mm(view.picture.depth));
    }
    report();
    return coco_annotation(database_, row, view);
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress(done_, options_.rows.size());
  }

  const Database& database_;
  const fs::path directory_;
  const CocoOptions& options_;
  const DatabaseRows rows_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

void export_coco(const Database& database, const fs::path& directory, const CocoOptions& options) {
  GRASPDB_CHECK(!options.rows.empty() && std::ranges::is_sorted(options.rows));
  GRASPDB_CHECK(options.rows.back() < database.rows());
  Exporter(database, directory, options).run();
}

}  // namespace graspdb
