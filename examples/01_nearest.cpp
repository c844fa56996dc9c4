// SPDX-License-Identifier: MIT
// The rows of a database whose pictures look most like that of one row:
//   01_nearest hands.graspdb ROW [COUNT]
#include <iostream>
#include <string>

#include "graspdb/database/database.h"
#include "graspdb/database/search.h"

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("01_nearest hands.graspdb ROW [COUNT]");
  const auto database = graspdb::Database::open(argv[1]);
  const std::size_t row = std::stoul(argv[2]);
  if (row >= database.rows()) throw std::runtime_error("the database has no such row");

  // Of a picture and its mask, graspdb::Describer (tracker) makes such a descriptor.
  const graspdb::DescriptorView descriptor = database.descriptors().row(row);

  const auto search = graspdb::open_search(database, graspdb::kDefaultSearch);
  const int count = argc > 3 ? std::stoi(argv[3]) : 10;
  for (const graspdb::Neighbor& near : search->nearest(descriptor, count)) {
    std::cout << "row " << near.row << ": grasp " << database.grasp(near.row) << ", view "
              << database.view(near.row) << ", squared distance " << near.squared_distance << "\n";
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
