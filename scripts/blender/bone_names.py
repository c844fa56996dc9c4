# SPDX-License-Identifier: MIT
"""Guesses from their names which bones of a rig are which of graspdb's.

It knows how Blender's Rigify, MakeHuman, Mixamo, Unreal, VRM, WebXR and others call them. What it
is not sure of it leaves out: a wrong guess costs more than a missing one.
"""
import re

DIGITS = ("thumb", "index", "middle", "ring", "little")
FINGER_BONES = ("metacarpal", "proximal", "middle", "distal")
THUMB_BONES = ("metacarpal", "proximal", "distal")
BONES = ("palm", "forearm") + tuple(
    f"{digit}_{bone}"
    for digit in DIGITS
    for bone in (THUMB_BONES if digit == "thumb" else FINGER_BONES)
)

SIDES = {"l": "left", "left": "left", "r": "right", "right": "right"}
DIGIT_WORDS = {"pinky": "little", "pinkie": "little", **{digit: digit for digit in DIGITS}}
SEGMENT_WORDS = {
    "metacarpal": "metacarpal",
    "carpal": "metacarpal",
    "proximal": "proximal",
    "intermediate": "middle",
    "medial": "middle",
    "middle": "middle",
    "distal": "distal",
    "tip": "tip",
    "end": "tip",
    "nub": "tip",
}
HELPERS = set("ik fk pole target ctrl control mch org prop weapon socket".split())


def words_of(name):
    """mixamorig:RightHandIndex1 -> ["right", "hand", "index", "1"]"""
    name = re.split(r"[:|]", name)[-1]
    return [w.lower() for w in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)]


def side_of(name):
    """left, right, or None where the name says neither (or both)."""
    sides = {SIDES[word] for word in words_of(name) if word in SIDES}
    return sides.pop() if len(sides) == 1 else None


def digit_and_segment(words):
    """Of a digit's bone: its digit, and its segment as a word or a number; None where unknown."""
    words = [word for word in words if word not in SIDES]
    numbers = [int(word) for word in words if word.isdigit()]
    if words[:1] == ["finger"] and len(words) == 3 and len(numbers) == 2:  # MakeHuman
        return (DIGITS[numbers[0] - 1], numbers[1]) if 1 <= numbers[0] <= 5 else (None, None)
    found = [word for word in words if word in DIGIT_WORDS]
    if not found:
        if {"metacarpal", "carpal", "palm"} & set(words) and numbers and 1 <= numbers[0] <= 4:
            return DIGITS[numbers[0]], "metacarpal"
        return None, None
    # In index_middle it is the segment.
    digit = next((word for word in found if word != "middle"), "middle")
    words.remove(digit)
    segments = [SEGMENT_WORDS[word] for word in words if word in SEGMENT_WORDS]
    if segments:
        return DIGIT_WORDS[digit], segments[-1]
    return DIGIT_WORDS[digit], numbers[0] if len(numbers) == 1 else None


def arm_bone(words):
    """palm, forearm, or None."""
    if {"forearm", "lowerarm", "elbow"} & set(words):
        return "forearm"
    if "arm" in words and {"fore", "lower"} & set(words):
        return "forearm"
    return "palm" if {"wrist", "hand", "palm"} & set(words) else None


def only(names):
    return names[0] if len(names) == 1 else None


def name_numbered(digit, numbered):
    """Gives the numbered bones of a digit (in order) their segments, if their count is clear."""
    segments = THUMB_BONES if digit == "thumb" else FINGER_BONES
    if digit != "thumb" and len(numbered) == 3:
        segments = FINGER_BONES[1:]
    return dict(zip(segments, numbered)) if len(numbered) == len(segments) else {}


def thumb_by_words(found):
    """Some call a thumb's bones proximal, intermediate, distal."""
    if "middle" in found and "metacarpal" not in found:
        found["metacarpal"] = found.pop("proximal", None)
        found["proximal"] = found.pop("middle")
    return found


def name_digit(digit, names_by_segment, skinned):
    """segment (or tip) -> bone, of one digit."""
    found, numbered = {}, []
    for segment, names in sorted(names_by_segment.items(), key=lambda item: str(item[0])):
        # Controls go by the same names as the bones that they control.
        name = only([n for n in names if n in skinned] or names)
        if isinstance(segment, int):
            numbered.append(name)
        elif name:
            found[segment] = name
    if digit == "thumb":
        found = thumb_by_words(found)
    if len(numbered) > 3 and numbered[-1] not in skinned:
        found.setdefault("tip", numbered.pop())
    for segment, name in name_numbered(digit, numbered).items():
        found.setdefault(segment, name)
    return {segment: name for segment, name in found.items() if name}


def guess_arm(names, skinned):
    """palm and forearm -> the bones that are sure to be theirs."""
    found = {"palm": [], "forearm": []}
    for name in names:
        words = words_of(name)
        bone = arm_bone(words)
        if bone and digit_and_segment(words)[0] is None:
            found[bone].append(name)
    found = {bone: [n for n in names if n in skinned] or names for bone, names in found.items()}
    # The first gives the joint: the wrist, if one is called so; of a forearm the one without twist.
    found["palm"].sort(key=lambda name: "wrist" not in words_of(name))
    found["forearm"].sort(key=lambda name: "twist" in words_of(name))
    return {bone: names for bone, names in found.items() if names}


def guess(names, skinned, side=None):
    """Returns ({bone: [names]}, {digit: name of its tip}).

    `skinned` are those of `names` that move skin. Bones of the other side than `side` are left out.
    """
    if side:
        names = [name for name in names if side_of(name) in (side, None)]
    names = [name for name in names if not HELPERS & set(words_of(name)) or name in skinned]
    bones, tips, digits = guess_arm(names, skinned), {}, {digit: {} for digit in DIGITS}
    for name in names:
        digit, segment = digit_and_segment(words_of(name))
        if segment is not None:
            digits[digit].setdefault(segment, []).append(name)
    for digit, names_by_segment in digits.items():
        for segment, name in name_digit(digit, names_by_segment, skinned).items():
            if segment == "tip":
                tips[digit] = name
            elif f"{digit}_{segment}" in BONES:
                bones[f"{digit}_{segment}"] = [name]
    return bones, tips
