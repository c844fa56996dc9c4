# SPDX-License-Identifier: MIT
"""From light to a JPEG: exposure, film curve, lens, sensor."""
import cv2
import numpy as np

SPECK = 14  # grey levels that a lone pixel sticks out by


def jpeg_options(quality):
    return [cv2.IMWRITE_JPEG_QUALITY, quality, cv2.IMWRITE_JPEG_OPTIMIZE, 1]


def compose(foreground, plate):
    return foreground[:, :, :3] + (1 - foreground[:, :, 3:]) * plate


def luminance(linear):
    return linear @ np.array([0.2126, 0.7152, 0.0722], np.float32)


def film(linear, white=4.0, saturation=1.2):
    """Linear to sRGB 0..255 with a soft shoulder; `white` is where it clips."""
    bent = linear * (1 + linear / white**2) / (1 + linear)
    grey = luminance(bent)[:, :, None]  # the shoulder takes colour away
    bent = np.clip(grey + saturation * (bent - grey), 0, 1)
    srgb = np.where(bent <= 0.0031308, 12.92 * bent, 1.055 * bent ** (1 / 2.4) - 0.055)
    return 255 * srgb


def exposure(plate, metered):
    """Half for the whole picture, half for what is in front, as cameras that find it do."""
    whole = np.exp(np.log(luminance(compose(metered, plate)) + 1e-4).mean())
    front = metered[metered[:, :, 3] > 0.99]
    return 0.31 / np.sqrt(whole * np.median(luminance(front[:, :3])))


class Camera:
    """Takes pictures of one room with one exposure."""

    def __init__(self, seed, look, plate, metered):
        self.seed, self.look = seed, look
        self.exposure = look["exposure"] * exposure(plate, metered)
        room = film(self.exposure * plate)
        self.room = denoised(room, np.ones(room.shape[:2], bool), look["denoise"])

    def photograph(self, foreground, frame):
        alpha = foreground[:, :, 3:]
        front = film(self.exposure * foreground[:, :, :3] / np.maximum(alpha, 1e-3))
        picture = alpha * denoised(front, alpha[:, :, 0] > 0, self.look["denoise"])
        picture += (1 - alpha) * self.room
        if self.look["blur_px"] > 0:
            picture = cv2.GaussianBlur(picture, (0, 0), self.look["blur_px"])
        rng = np.random.default_rng([self.seed, frame])
        picture = picture + self.look["sensor_noise"] * rng.standard_normal(picture.shape)
        return np.clip(np.rint(picture), 0, 255).astype(np.uint8)[:, :, ::-1]


def denoised(picture, where, strength):
    """The box around `where`, sRGB 0..255, without what few samples leave."""
    if strength == 0 or not where.any():
        return picture
    rows, columns = np.nonzero(where.any(axis=1))[0], np.nonzero(where.any(axis=0))[0]
    box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    noisy = np.ascontiguousarray(np.rint(picture[box]).astype(np.uint8))
    median = cv2.medianBlur(noisy, 3)
    specks = np.abs(noisy.astype(int) - median).max(axis=2, keepdims=True) > SPECK
    noisy = np.where(specks, median, noisy)
    picture = picture.copy()
    picture[box] = cv2.fastNlMeansDenoisingColored(noisy, None, strength, strength, 3, 11)
    return picture
