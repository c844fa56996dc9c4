# SPDX-License-Identifier: MIT
"""docs/library.md prints the examples as they are."""
import textwrap
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class LibraryPage(unittest.TestCase):
    def test_prints_every_example_as_it_is(self):
        page = (ROOT / "docs/library.md").read_text(encoding="utf-8")
        examples = sorted((ROOT / "examples").glob("*.cpp"))
        self.assertEqual(len(examples), 3)
        for example in examples:
            _, code = example.read_text(encoding="utf-8").split("\n", 1)  # not its licence
            with self.subTest(example.name):
                self.assertIn(f"### {example.name}\n\n{textwrap.indent(code, '    ')}", page)


if __name__ == "__main__":
    unittest.main()
