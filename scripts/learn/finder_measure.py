# SPDX-License-Identifier: MIT
"""How well a finder's hands agree with those of photoreal frames."""

import pathlib
import subprocess

import cv2
import numpy
import torch
import torch.nn.functional as F

from finder_pictures import CLASS_OF_LABEL, HAND, HEIGHT, WIDTH

BATCH = 32


def labels_of(program, sequence, work):
    """The label pictures of a sequence, made once."""
    folder = work / sequence.name.removesuffix(".seq.toml")
    if not (folder / "meshes.json").exists():
        subprocess.run([str(program), "sequence", str(sequence), "--meshes", str(folder)], check=True,
                       stdout=subprocess.DEVNULL)
    return sorted((folder / "labels").glob("*.png"))


def frames_of(options, names):
    """Pairs of the files of a photoreal frame and its labels, of these sequences."""
    pairs = []
    for name in names:
        labels = labels_of(options.program, pathlib.Path(options.sequences) / f"{name}.seq.toml", options.work)
        pairs += [(pathlib.Path(options.photoreal) / name / f"{path.stem}.jpg", path) for path in labels]
    return pairs


class Photoreal:
    """Every third photoreal frame of the sequences, shrunk as the finder wants them, and their labels."""

    def __init__(self, options, learned_from=()):
        self.frames, self.labels, self.sequence = [], [], []
        names = sorted(path.name for path in pathlib.Path(options.photoreal).iterdir() if path.is_dir())
        for name in names:
            if name in learned_from:
                continue
            for frame, labels in frames_of(options, [name])[::3]:
                self.frames.append(cv2.resize(cv2.imread(str(frame)), (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA))
                self.labels.append(CLASS_OF_LABEL[cv2.imread(str(labels), cv2.IMREAD_GRAYSCALE)] == HAND)
                self.sequence.append(name)

    def figures(self, scores_of):
        """IoU by sequence; `scores_of` gives scores [N, classes, h, w] of BGR bytes."""
        by_name = {}
        for start in range(0, len(self.frames), BATCH):
            scores = scores_of(numpy.stack(self.frames[start:start + BATCH]))
            for i, score in enumerate(scores, start):
                hand = hand_of(score, self.labels[i].shape)
                by_name.setdefault(self.sequence[i], []).append(iou(hand, self.labels[i]))
        return {name: float(numpy.mean(values)) for name, values in by_name.items()}


def hand_of(scores, shape):
    wide = F.interpolate(scores[None].float(), size=shape, mode="bilinear", align_corners=False)[0]
    return (wide.argmax(0) == HAND).numpy()


def iou(a, b):
    return (a & b).sum() / max((a | b).sum(), 1)


def tell(figures):
    mean = numpy.mean(list(figures.values()))
    print(f"  IoU {mean:.3f}  " + "  ".join(f"{name} {value:.3f}" for name, value in figures.items()), flush=True)


def scores_of_net(net):
    def scores(pictures):
        net.eval()
        device = next(net.parameters()).device
        with torch.no_grad():
            return net(torch.as_tensor(pictures).to(device).permute(0, 3, 1, 2).float() / 255).cpu()
    return scores
