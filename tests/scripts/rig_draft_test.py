# SPDX-License-Identifier: MIT
"""What the draft of a rig map leaves to a person."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "blender"))
# pylint: disable=wrong-import-position
from bone_names import BONES, DIGITS
from rig_draft import FILL_IN, draft

WHOLE = {bone: [bone.upper()] for bone in BONES}
TIPS = {digit: f"{digit}_tip" for digit in DIGITS}


def draft_of(bones, side="right", nail=(0, 0.6, 0.8), tips=None, tails=None, idle=(), others=()):
    skinned = {name for names in bones.values() for name in names} | set(others)
    names = [*sorted(skinned), *idle]
    return draft("A hand.", side, nail, bones, tips or {}, tails or {}, names, skinned)


class Draft(unittest.TestCase):
    def test_nothing_is_left_of_a_whole_rig(self):
        text = draft_of(WHOLE, tips=TIPS)
        self.assertNotIn(FILL_IN, text)
        self.assertIn('\nhandedness = "right"\n', text)
        self.assertIn("\nthumb_nail = [0, 0.6, 0.8]\n", text)
        self.assertIn('\nlittle_distal = ["LITTLE_DISTAL"]\n', text)
        self.assertIn('\nthumb = "thumb_tip"\n', text)

    def test_side_and_nail_are_asked_for(self):
        text = draft_of(WHOLE, side=None, nail=None)
        self.assertEqual(text.count(FILL_IN), 2)
        self.assertIn(FILL_IN + "thumb_nail", text)
        self.assertIn(FILL_IN + "handedness", text)

    def test_missing_phalanges_are_asked_for_missing_metacarpals_are_not(self):
        missing = ("index_metacarpal", "index_middle", "thumb_metacarpal")
        text = draft_of({bone: names for bone, names in WHOLE.items() if bone not in missing})
        self.assertEqual(text.count(FILL_IN), 2)
        self.assertIn(FILL_IN + "index_middle = ", text)
        self.assertIn(FILL_IN + "thumb_metacarpal = ", text)

    def test_missing_forearm_asks_for_its_rule_after_all_other_tables(self):
        text = draft_of({bone: names for bone, names in WHOLE.items() if bone != "forearm"})
        self.assertEqual(text.count(FILL_IN), 1)
        self.assertGreater(text.index("# [forearm]"), text.index("[tips]"))

    def test_a_tip_without_a_joint_is_where_its_bone_ends(self):
        text = draft_of(WHOLE, tips={"thumb": "t"}, tails={d: (1, 2, 3) for d in DIGITS})
        self.assertIn('\nthumb = "t"\n', text)
        self.assertNotIn("thumb_position", text)
        self.assertIn("\nring_position = [1, 2, 3]\n", text)

    def test_bones_without_a_place_are_listed_by_whether_they_move_skin(self):
        text = draft_of(WHOLE, idle=["ik_hand"], others=["watch"])
        self.assertRegex(text, r"These move skin too(.*\n)*#   watch\n")
        self.assertRegex(text, r"These move no skin(.*\n)*#   ik_hand\n")


unittest.main()
