# SPDX-License-Identifier: MIT
"""Looks that are drawn, for training pictures: those of photoreal.toml are of evaluation sequences, and what
they have, skins, rooms and things, is in no training picture."""
import numpy as np

# From light to dark, sRGB; tones lie between neighbours.
SKINS = np.array([(0.96, 0.82, 0.75), (0.89, 0.69, 0.57), (0.72, 0.51, 0.38), (0.50, 0.34, 0.25), (0.27, 0.18, 0.14)])
PALM = np.array([0.88, 0.64, 0.56])
RED = np.array([0.93, 0.67, 0.65])  # what blood takes of the light
LEAST_APART = 0.02  # of tones, sRGB
WARM, COLD = np.array([1.0, 0.76, 0.55]), np.array([0.85, 0.92, 1.0])
STEEPEST_DEG = 65  # that the picture's lower edge looks down: there the table begins
OBJECTS = ("plastic", "metal", "wood", "glossy", "rubber", "labelled")


def tone(rng, others):
    while True:
        place = rng.uniform(0, len(SKINS) - 1)
        i = int(place)
        mixed = SKINS[i] + (place - i) * (SKINS[i + 1] - SKINS[i])
        mixed = np.clip(mixed * rng.uniform(0.96, 1.04, 3), 0, 1)
        if all(np.abs(mixed - other).max() > LEAST_APART for other in others):
            return mixed


def any_colour(rng):
    """Grey as often as not: walls and cloths are."""
    grey = rng.uniform(0.05, 0.95)
    return np.clip(grey + rng.normal(0, rng.choice([0.02, 0.15]), 3), 0.02, 1)


def skin(rng, others):
    mixed = tone(rng, others)
    palm = mixed + rng.uniform(0.2, 0.7) * (np.maximum(PALM, mixed) - mixed)
    return {
        "skin": mixed,
        "skin_red": mixed * (1 + rng.uniform(0.5, 1.2) * (RED - 1)),
        "skin_palm": palm,
        "nail": np.clip(palm * rng.uniform(1.0, 1.1), 0, 1),
        "skin_roughness": rng.uniform(0.35, 0.6),
        "wrinkles": rng.uniform(0.2, 0.7),
        "blotches": rng.uniform(0, 0.6),
        "freckles": rng.choice([0, 0, 0, rng.uniform(0.1, 0.5)]),
    }


def arm(rng):
    """A sleeve of cloth, or a bare arm; long enough to leave nearly any picture."""
    if rng.random() < 0.35:
        return {"sleeve": [0, 0, 0], "arm": "bare", "upper_arm_m": 2.0}
    return {"sleeve": any_colour(rng), "arm": "sleeve", "upper_arm_m": 2.0}


def light(rng):
    def lamp():
        return 1 - rng.uniform(0, 1) * (1 - (WARM if rng.random() < 0.6 else COLD))

    return {
        "key": lamp(),
        "fill": lamp(),
        "key_size": rng.uniform(0.1, 1.2),
        "ambient": np.exp(rng.uniform(np.log(0.2), np.log(1.5))),
        "exposure": np.exp(rng.normal(0, 0.25)),
    }


def camera(rng, half_height_deg):
    return {
        "camera_down_deg": rng.uniform(-5, min(50, STEEPEST_DEG - half_height_deg)),
        "fstop": np.exp(rng.uniform(np.log(2.0), np.log(16.0))),
        "blur_px": rng.choice([0, rng.uniform(0.3, 1.0)]),
        "sensor_noise": rng.uniform(0.5, 5),
    }


def draw(common, rng, others, half_height_deg):
    """A look on top of what all have; `others` are skin tones that it must not have."""
    look = common | {"room": "clutter", "depth": rng.uniform(0.3, 1.5), "object_kind": rng.choice(OBJECTS)}
    look |= skin(rng, others) | arm(rng) | light(rng) | camera(rng, half_height_deg) | {"object": any_colour(rng)}
    return {key: value.tolist() if isinstance(value, np.generic | np.ndarray) else value for key, value in look.items()}
