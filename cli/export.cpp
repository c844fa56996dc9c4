// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "checks.h"
#include "console.h"
#include "graspdb/pictures/export_coco.h"
#include "row_selection.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct ExportArguments {
  std::string database, format = "coco", out;
  RowSelection selection;
  CocoOptions coco;
};

void run(ExportArguments& options) {
  const Database database = Database::open(options.database);
  options.coco.rows = chosen_rows(database, options.selection);
  options.coco.progress = console_progress("exported", "rows");
  export_coco(database, options.out, options.coco);
  fmt::print("{}: {} pictures with their annotations\n", options.out, options.coco.rows.size());
}

}  // namespace

void add_export(CLI::App& app) {
  auto options = std::make_shared<ExportArguments>();
  CLI::App* verb =
      app.add_subcommand("export", "Write rows of a database as pictures in another format");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--format", options->format, "coco: COCO keypoints (docs/export.md)")
      ->check(one_of({"coco"}));
  verb->add_option("--out", options->out,
                   "The folder to write to: new, empty, or an earlier export")
      ->required()
      ->check(output_folder());
  add_row_selection(*verb, options->selection);
  verb->add_option("--resolution", options->coco.resolution,
                   "Side of a picture, pixels [the database's]")
      ->check(range(16, 1024));
  verb->add_flag("--amodal", options->coco.amodal, "Also masks of hand and object as if alone");
  verb->add_flag("--depth", options->coco.depth, "Also depth, 16-bit PNG in mm");
  verb->add_option("--threads", options->coco.threads,
                   "Threads, 0 for all processors; changes no byte")
      ->check(range(0, 1024));
  verb->footer("Example: graspdb export hands.graspdb --sample 5000 --resolution 256 --out coco");
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
