# SPDX-License-Identifier: MIT
"""docs/architecture.md's table, the CMakeLists and the #includes say the same of who uses whom."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUR_INCLUDE = re.compile(r'^#include "graspdb/([^"\n]*)/[^"/\n]*"', re.MULTILINE)
LINKING = re.compile(r"(?:graspdb_library|target_link_libraries)\((\w+\s[^)]*)\)")


def files(pattern):
    """The paths of all files of that name below the folders that CMake builds."""
    folders = [path.parent for path in ROOT.glob("*/CMakeLists.txt")]
    return [str(path.relative_to(ROOT)) for folder in folders for path in folder.rglob(pattern)]


def of_rooms(paths):
    return [path for path in paths if not path.startswith(("tests/", "examples/"))]


def targets_in(cell):
    return set(re.findall(r"`(\w+)`", cell))


def table():
    """{folder: (target, targets that its users get too, targets of its own)} of the document."""
    rows = {}
    for line in (ROOT / "docs/architecture.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 4 and re.fullmatch(r"`\w+`", cells[1]):
            public, _, private = cells[3].partition("inside:")
            rows[cells[0]] = (cells[1].strip("`"), targets_in(public), targets_in(private))
    return rows


def cmake_links(folder):
    """Our targets that the targets of a folder link: (those that its users get too, the others)."""
    links = {"PUBLIC": set(), "PRIVATE": set()}
    for call in LINKING.findall((ROOT / folder / "CMakeLists.txt").read_text()):
        for word in call.replace("INTERFACE", "PUBLIC").split()[1:]:
            if word.isupper():
                keyword = word
            elif word.startswith("graspdb::"):
                links[keyword].add(word.removeprefix("graspdb::"))
    return links["PUBLIC"], links["PRIVATE"] - links["PUBLIC"]


class Layers(unittest.TestCase):
    def setUp(self):
        self.table = table()
        self.folder_of = {target: folder for folder, (target, _, _) in self.table.items()}

    def reachable(self, folder):
        """The folders whose public headers this one sees: its links, and what those pass on."""
        _, public, private = self.table[folder]
        found, waiting = set(), public | private
        while waiting:
            target = waiting.pop()
            if target not in found:
                found.add(target)
                waiting |= self.table[self.folder_of[target]][1]
        return {self.folder_of[target] for target in found} | {folder}

    def test_the_table_has_every_folder_with_code(self):
        folders = {str(Path(path).parent) for path in of_rooms(files("CMakeLists.txt"))}
        self.assertEqual(set(self.table), folders)

    def test_the_table_names_what_the_cmakelists_link(self):
        for folder, (_, public, private) in self.table.items():
            with self.subTest(folder):
                self.assertEqual((public, private - public), cmake_links(folder))

    def test_a_file_includes_only_what_the_table_lets_its_folder_see(self):
        for path in of_rooms(files("*.cpp") + files("*.h")):
            folder = max((folder for folder in self.table if path.startswith(f"{folder}/")), key=len)
            included = set(OUR_INCLUDE.findall((ROOT / path).read_text()))
            with self.subTest(path):
                self.assertLessEqual(included, self.reachable(folder))


class HeaderFilter(unittest.TestCase):
    def test_clang_tidy_looks_at_all_headers_of_ours_and_at_no_other(self):
        text = (ROOT / ".clang-tidy").read_text()
        header_filter = re.compile(re.search("^HeaderFilterRegex: '(.*)'$", text, re.MULTILINE)[1])
        for path in files("*.h"):
            with self.subTest(path):
                self.assertRegex(f"/anywhere/{path}", header_filter)
        for path in ("include/fmt/core.h", "include/opencv4/opencv2/video/tracking.hpp"):
            self.assertNotRegex(f"/usr/{path}", header_filter)


if __name__ == "__main__":
    unittest.main()
