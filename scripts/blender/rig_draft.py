# SPDX-License-Identifier: MIT
"""Writes the draft of a rig map: what is known of a rig, and what a person has to fill in."""
import json

from bone_names import BONES, DIGITS

FILL_IN = "# fill in: "
# The wrist's skin bends over this much in graspdb's own hands.
FOREARM_RULE = """\
# fill in: forearm = ["..."] above, or, when none of the file's bones is the forearm, the rule by
# which the palm's skin beyond the wrist becomes one (mm; docs/hands.md):
# [forearm]
# split_at_mm = 0
# split_width_mm = 75
# extend_mm = 0
"""


def quoted(text):
    return json.dumps(text, ensure_ascii=False)


def vector(numbers):
    return "[" + ", ".join(f"{number:.7g}" for number in numbers) + "]"


def is_optional(bone):
    return bone == "forearm" or bone.endswith("_metacarpal") and not bone.startswith("thumb")


def head(side, nail):
    yield f"handedness = {quoted(side)}" if side else FILL_IN + 'handedness = "right" or "left"'
    yield "# The way the thumb's nail faces in the file's rest pose, in the file's coordinates."
    if nail:
        yield f"thumb_nail = {vector(nail)}"
        return
    yield "# No rig tells it. In Blender: select the nail's faces in Edit Mode, save, and export"
    yield "# again with --nail selected."
    yield FILL_IN + "thumb_nail = [x, y, z]"


def bone_lines(bones):
    yield "\n[bones]"
    for bone in BONES:
        if bone in bones:
            yield f"{bone} = [" + ", ".join(map(quoted, bones[bone])) + "]"
        elif bone == "forearm":
            continue  # it has a rule of its own
        elif is_optional(bone):
            yield f"# {bone} = [...]  # none was found; leave it out when the file has none"
        else:
            yield FILL_IN + f'{bone} = ["..."]'


def tip_lines(tips, tails):
    """`tails` has the far ends of distal bones, for the digits without a joint at the tip."""
    yield "\n[tips]"
    if set(tails) - set(tips):
        yield "# Positions are the far ends of the last bones. Delete one that does not lie at the"
        yield "# very tip: graspdb then takes the place where the last bone leaves the skin."
    for digit in DIGITS:
        if digit in tips:
            yield f"{digit} = {quoted(tips[digit])}"
        elif digit in tails:
            yield f"{digit}_position = {vector(tails[digit])}"
        else:
            yield f'# {digit} = "..."  # none was found; leave it out when the file has none'


def left_over_lines(bones, tips, names, skinned):
    """Comments on the bones that the map does not name."""
    named = {name for names in bones.values() for name in names} | set(tips.values())
    left = [name for name in names if name not in named]
    moving = [name for name in left if name in skinned]
    if moving:
        yield "\n# These move skin too: graspdb refuses the hand until each is added to the bone"
        yield "# that it belongs to (a list may have several names), or its skin is deleted."
        yield from (f"#   {name}" for name in moving)
    idle = [name for name in left if name not in skinned]
    if idle:
        yield "\n# These move no skin and need no name:"
        yield from (f"#   {name}" for name in idle)


def draft(title, side, nail, bones, tips, tails, names, skinned):
    """The text of the rig map. `bones` and `tips` are bone_names.guess's."""
    lines = [f"# {title}", *head(side, nail), *bone_lines(bones), *tip_lines(tips, tails)]
    if "forearm" not in bones:
        lines.append("\n" + FOREARM_RULE.rstrip())
    lines += left_over_lines(bones, tips, names, skinned)
    return "\n".join(lines) + "\n"
