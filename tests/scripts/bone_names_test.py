# SPDX-License-Identifier: MIT
"""What the bones of well-known rigs are taken for."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "blender"))
# pylint: disable=wrong-import-position
from bone_names import BONES, DIGITS, guess, side_of, words_of

METACARPALS = {f"{digit}_metacarpal" for digit in DIGITS[1:]}
PINKY = ("thumb", "index", "middle", "ring", "pinky")


def numbered(pattern, numbers, digits=PINKY):
    return [pattern.format(digit, n) for digit in digits for n in numbers]


class WordsOfAName(unittest.TestCase):
    def test_capitals_signs_and_digits_part_words(self):
        self.assertEqual(words_of("mixamorig:RightHandIndex1"), ["right", "hand", "index", "1"])
        self.assertEqual(words_of("rIndex1"), ["r", "index", "1"])
        self.assertEqual(words_of("DEF-f_index.01.L"), ["def", "f", "index", "01", "l"])

    def test_side_is_unknown_unless_a_word_tells(self):
        self.assertEqual(side_of("hand_l"), "left")
        self.assertEqual(side_of("RightHand"), "right")
        self.assertIsNone(side_of("lowerarm"))
        self.assertIsNone(side_of("little_distal"))


class Guess(unittest.TestCase):
    def assert_all_but(self, missing, bones):
        self.assertEqual(set(BONES) - set(bones), set(missing))

    def test_graspdbs_own_names_are_their_own_guess(self):
        tips = [f"{digit}_tip" for digit in DIGITS]
        bones, found_tips = guess([*BONES, *tips], set(BONES))
        self.assertEqual(bones, {bone: [bone] for bone in BONES})
        self.assertEqual(found_tips, dict(zip(DIGITS, tips)))

    def test_mixamo_ends_digits_in_a_fourth_bone_without_skin(self):
        digits = [digit.capitalize() for digit in PINKY]
        skinned = ["mixamorig:LeftForeArm", "mixamorig:LeftHand"]
        skinned += numbered("mixamorig:LeftHand{}{}", (1, 2, 3), digits)
        ends = numbered("mixamorig:LeftHand{}{}", (4,), digits)
        bones, tips = guess(skinned + ends, set(skinned))
        self.assert_all_but(METACARPALS, bones)
        self.assertEqual(bones["thumb_metacarpal"], ["mixamorig:LeftHandThumb1"])
        self.assertEqual(bones["index_proximal"], ["mixamorig:LeftHandIndex1"])
        self.assertEqual(tips, dict(zip(DIGITS, ends)))

    def test_rigify_moves_skin_by_def_bones(self):
        digits = ("thumb", "f_index", "f_middle", "f_ring", "f_pinky")
        controls = ["palm.R", "hand_ik.R", "f_index.01.R.001"]
        controls += numbered("{}.0{}.R", (1, 2, 3), digits)
        skinned = ["DEF-forearm.R", "DEF-forearm.R.001", "DEF-hand.R"]
        skinned += numbered("DEF-{}.0{}.R", (1, 2, 3), digits)
        skinned += [f"DEF-palm.0{n}.R" for n in (1, 2, 3, 4)]
        bones, tips = guess(controls + skinned, set(skinned))
        self.assert_all_but([], bones)
        self.assertEqual(sorted(sum(bones.values(), [])), sorted(skinned))
        self.assertEqual(bones["forearm"], ["DEF-forearm.R", "DEF-forearm.R.001"])
        self.assertEqual(bones["little_metacarpal"], ["DEF-palm.04.R"])
        self.assertEqual(tips, {})

    def test_unreal_has_two_hands_and_twist_bones(self):
        names = [
            f"{name}_{side}"
            for side in "lr"
            for name in (
                *numbered("{}_0{}", (1, 2, 3)),
                *(f"{digit}_metacarpal" for digit in PINKY[1:]),
                *("hand", "lowerarm_twist_01", "lowerarm", "upperarm"),
            )
        ]
        bones, _ = guess([*names, "ik_hand_l"], set(names), "left")
        self.assert_all_but([], bones)
        self.assertEqual(bones["palm"], ["hand_l"])
        self.assertEqual(bones["forearm"], ["lowerarm_l", "lowerarm_twist_01_l"])
        self.assertEqual(bones["middle_distal"], ["middle_03_l"])

    def test_makehuman_counts_its_fingers_from_the_thumb(self):
        names = ["lowerarm01.L", "lowerarm02.L", "wrist.L"]
        names += [f"metacarpal{n}.L" for n in (1, 2, 3, 4)]
        names += numbered("finger{}-{}.L", (1, 2, 3), range(1, 6))
        bones, _ = guess(names, set(names))
        self.assert_all_but([], bones)
        self.assertEqual(bones["thumb_distal"], ["finger1-3.L"])
        self.assertEqual(bones["index_metacarpal"], ["metacarpal1.L"])

    def test_unity_calls_the_thumbs_metacarpal_proximal(self):
        parts = ("Proximal", "Intermediate", "Distal")
        digits = [digit.capitalize() for digit in DIGITS]
        names = ["RightLowerArm", "RightHand", *numbered("Right{}{}", parts, digits)]
        bones, _ = guess(names, set(names))
        self.assert_all_but(METACARPALS, bones)
        self.assertEqual(bones["thumb_metacarpal"], ["RightThumbProximal"])
        self.assertEqual(bones["thumb_proximal"], ["RightThumbIntermediate"])

    def test_four_thumb_bones_with_skin_are_left_to_a_person(self):
        names = ["b_r_wrist", *(f"b_r_thumb{n}" for n in range(4))]
        bones, tips = guess(names, set(names))
        self.assertEqual((bones, tips), ({"palm": ["b_r_wrist"]}, {}))

    def test_numbers_without_a_fingers_name_are_left_to_a_person(self):
        names = ["Bip01 R Hand", *(f"Bip01 R Finger{f}{n}" for f in range(5) for n in ("", 1, 2))]
        self.assertEqual(guess(names, set(names)), ({"palm": ["Bip01 R Hand"]}, {}))


unittest.main()
