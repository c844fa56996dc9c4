# SPDX-License-Identifier: MIT
"""Training pictures of the finder: hands before rooms, both from scripts/blender/photoreal_scenes.py, put together
anew each time, as cameras of any kind see them."""

import pathlib

import cv2
import numpy as np

WIDTH, HEIGHT = 160, 120
SOURCE = (320, 240)  # what is kept of a rendered picture
BRIGHTEST = 4  # of light in the files, at 65535
HAND, OBJECT = 1, 3
CLASS_OF_LABEL = np.array([0, 1, 2, 3, 2], np.uint8)  # a sleeve is arm
REST_OR_ARM = 4
CLASS_OF_FRAME = np.array([REST_OR_ARM, HAND, REST_OR_ARM, OBJECT], np.uint8)
HANDS = (0.1, 0.75, 0.15)  # shares of pictures with none, one and two
SMALLEST_CROP = 0.4
OTHER_ROOM = 0.7
FRAMES = 0.2  # of the pictures, when there are any
PRINTED = 0.6  # of the objects
BEHIND, BEFORE = 1.0, 0.25  # drawn things: how many lie behind the hands, and share of pictures with one before a hand


def middle(mask):
    """Shares of the picture."""
    rows, columns = np.nonzero(mask)
    return (columns.mean() / mask.shape[1], rows.mean() / mask.shape[0]) if len(rows) else (0.5, 0.5)


def shrunk(path):
    picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    small = cv2.resize(picture, SOURCE, interpolation=cv2.INTER_AREA)
    return np.rint(small / 257).astype(np.uint8)


class Pictures:
    def __init__(self, folders, frames=()):
        """All scenes of these folders, read into memory: 2 MB each. `frames`: pairs of a photoreal frame of a sequence
        and its labels, in which a sleeve is not told from the rest."""
        self.frames = [(cv2.resize(cv2.imread(str(frame)), SOURCE, interpolation=cv2.INTER_AREA),
                        cv2.resize(CLASS_OF_FRAME[cv2.imread(str(labels), cv2.IMREAD_GRAYSCALE)], SOURCE,
                                   interpolation=cv2.INTER_NEAREST)) for frame, labels in frames]
        self.rooms, self.fronts, self.labels, self.places, self.room_of = [], [], [], [], []
        for scene in sorted(path for folder in folders for path in pathlib.Path(folder).iterdir() if path.suffix == ""):
            for front in sorted(scene.glob("front*.png")):
                labels = cv2.imread(str(scene / front.name.replace("front", "labels")), cv2.IMREAD_GRAYSCALE)
                self.fronts.append(shrunk(front))
                self.labels.append(cv2.resize(CLASS_OF_LABEL[labels], SOURCE, interpolation=cv2.INTER_NEAREST))
                self.places.append(middle(self.labels[-1] == HAND))
                self.room_of.append(len(self.rooms))
            self.rooms.append(shrunk(scene / "room.png"))

    def draw(self, rng):
        """(BGR bytes [H, W, 3], classes [H, W])."""
        if self.frames and rng.random() < FRAMES:
            return self.draw_frame(rng)
        first = rng.integers(len(self.fronts))
        room = rng.integers(len(self.rooms)) if rng.random() < OTHER_ROOM else self.room_of[first]
        light = light_of(taken(self.rooms[room], crop(rng)))
        classes = np.zeros((HEIGHT, WIDTH), np.uint8)
        for _ in range(rng.poisson(BEHIND)):
            light, _ = with_thing(light, rng.uniform((0, 0), (HEIGHT, WIDTH)), rng)
        for number in range(rng.choice(len(HANDS), p=HANDS)):
            front = rng.integers(len(self.fronts)) if number else first
            light, classes = self.with_hand(light, classes, front, rng)
        if (classes == HAND).any() and rng.random() < BEFORE:
            light, shown = with_thing(light, rng.permutation(np.argwhere(classes == HAND))[0], rng)
            classes = np.where(shown, OBJECT, classes).astype(np.uint8)
        return photographed(light, rng), classes

    def draw_frame(self, rng):
        frame, classes = self.frames[rng.integers(len(self.frames))]
        window = crop(rng, middle(classes == HAND))
        light = np.power(taken(frame, window).astype(np.float32) / 255, 2.2) * 1.2
        return photographed(light, rng), taken(classes, window, cv2.INTER_NEAREST)

    def with_hand(self, light, classes, number, rng):
        window = crop(rng, self.places[number])
        front = taken(self.fronts[number], window)
        alpha = front[:, :, 3:].astype(np.float32) / 255
        brightness = np.exp(rng.normal(-0.1, 0.5))
        seen = taken(self.labels[number], window, cv2.INTER_NEAREST)
        own_light = light_of(front[:, :, :3])
        if rng.random() < PRINTED:
            own_light = with_print(own_light, seen == OBJECT, rng)
        light = brightness * own_light + (1 - alpha) * light
        return light, np.where(alpha[:, :, 0] > 0.5, seen, classes)


def turned_axes(place, turn):
    """How far each pixel lies from `place` (row, column) along a direction and beside it."""
    down, across = np.mgrid[:HEIGHT, :WIDTH] - np.asarray(place)[:, None, None]
    return np.cos(turn) * across + np.sin(turn) * down, np.cos(turn) * down - np.sin(turn) * across


def pattern(rng):
    """Where of two colours the second shows: blots, or stripes that run askew."""
    size = int(rng.integers(4, 40))
    field = cv2.resize(rng.standard_normal((size, size)).astype(np.float32), (WIDTH, HEIGHT), interpolation=cv2.INTER_CUBIC)
    if rng.random() < 0.6:
        turn, length = rng.uniform(0, np.pi), rng.uniform(4, 30)
        field = 0.4 * field + np.sin(2 * np.pi / length * turned_axes((0, 0), turn)[0])
    return field > rng.normal(0, 0.5)


def with_print(light, shown, rng):
    """Another colour for the pixels `shown`, shaded as they are, and a label of two colours on a part of them."""
    if not shown.any():
        return light
    grey = light.mean(axis=2)
    shade = np.clip(grey / max(grey[shown].mean(), 1e-3), 0, 3)[:, :, None]
    albedo = np.exp(rng.uniform(-2.5, 0.3, (3, 3))).astype(np.float32)
    if rng.random() < 0.5:  # a label of greys
        albedo[1:] = albedo[1:].mean(axis=1, keepdims=True)
    places = np.argwhere(shown)
    along, beside = turned_axes(places[rng.integers(len(places))], rng.uniform(0, np.pi))
    label = (np.abs(along) < rng.uniform(3, 60)) & (np.abs(beside) < rng.uniform(3, 60))
    color = np.where((label & pattern(rng))[:, :, None], albedo[2], np.where(label[:, :, None], albedo[1], albedo[0]))
    return np.where(shown[:, :, None], shade * color, light)


def with_thing(light, place, rng):
    """A block or a disc with a print, lit from one side; and where it shows. `place`: its middle, row and column."""
    turn, sides = rng.uniform(0, np.pi), np.exp(rng.uniform(np.log(6), np.log(110), 2))
    along, beside = (axis / side for axis, side in zip(turned_axes(place, turn), sides))
    shown = along**2 + beside**2 < 1 if rng.random() < 0.4 else np.maximum(abs(along), abs(beside)) < 1
    shade = np.exp(rng.normal(0, 0.5) * along + rng.normal(0, 0.5) * beside).clip(0.2, 3).astype(np.float32)
    plain = np.where(shown[:, :, None], shade[:, :, None] * light.mean(), light)
    return with_print(plain, shown, rng), shown


def light_of(bytes_):
    return BRIGHTEST * np.square(bytes_.astype(np.float32) / 255)


def crop(rng, shown=(0.5, 0.5)):
    """From the kept picture's pixels to the training picture's: a window of the one that has the place `shown` (shares
    of the picture) in it, perhaps turned over. Nothing from beyond the picture comes in: an arm that leaves it must not end in
    the middle of another."""
    share = np.exp(rng.uniform(np.log(SMALLEST_CROP), 0))
    scale = WIDTH / (share * SOURCE[0])
    x, y = (rng.uniform(max(0, place - share), min(place, 1 - share)) * side for place, side in zip(shown, SOURCE))
    window = np.array([[scale, 0, -x * scale], [0, scale, -y * scale]])
    if rng.random() < 0.5:
        window[0] = [-window[0, 0], 0, WIDTH - 1 - window[0, 2]]
    if rng.random() < 0.2:
        window[1] = [0, -window[1, 1], HEIGHT - 1 - window[1, 2]]
    return window


def taken(picture, window, interpolation=cv2.INTER_LINEAR):
    return cv2.warpAffine(picture, window, (WIDTH, HEIGHT), flags=interpolation, borderMode=cv2.BORDER_REPLICATE)


def film(light, rng):
    """As scripts/blender/photoreal_picture.py has it, with a curve of each camera's own."""
    bent = light * (1 + light / 16) / (1 + light)
    grey = bent @ np.array([0.0722, 0.7152, 0.2126], np.float32)
    bent = grey[:, :, None] + rng.uniform(0.6, 1.6) * (bent - grey[:, :, None])
    return 255 * np.clip(bent, 0, 1) ** (rng.uniform(0.8, 1.25) / 2.2)


def photographed(light, rng):
    light = light * np.exp(rng.normal(0, 0.35)) * np.exp(rng.normal(0, 0.1, 3)).astype(np.float32)
    picture = film(light, rng)
    if rng.random() < 0.5:
        picture = cv2.GaussianBlur(picture, (0, 0), rng.uniform(0.3, 1.2))
    picture = picture + rng.uniform(0, 8) * rng.standard_normal(picture.shape).astype(np.float32)
    picture = np.clip(np.rint(picture), 0, 255).astype(np.uint8)
    if rng.random() < 0.3:
        quality = int(rng.uniform(25, 95))
        picture = cv2.imdecode(cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, quality])[1], cv2.IMREAD_COLOR)
    return picture
