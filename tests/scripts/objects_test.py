# SPDX-License-Identifier: MIT
"""The committed objects are those that their lists make, byte for byte."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Objects(unittest.TestCase):
    def expect_as_committed(self, folder, count):
        with tempfile.TemporaryDirectory() as made:
            subprocess.run([sys.executable, "-B", folder / "make_objects.py", made], check=True)
            names = sorted(path.name for path in Path(made).iterdir())
            self.assertEqual(names, sorted(path.name for path in folder.glob("*.obj")))
            self.assertEqual(len(names), count)
            for name in names:
                same = (Path(made) / name).read_bytes() == (folder / name).read_bytes()
                self.assertTrue(same, folder / name)

    def test_what_the_grasps_hold(self):
        self.expect_as_committed(ROOT / "assets/objects", 3)

    def test_what_the_test_sequences_hold(self):
        self.expect_as_committed(ROOT / "sequences/test/objects", 13)

    def test_what_the_training_sequences_hold(self):
        self.expect_as_committed(ROOT / "sequences/train/objects", 5)


if __name__ == "__main__":
    unittest.main()
