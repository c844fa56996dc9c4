#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains the finder of hands on photographs of scripts/blender/photoreal_scenes.py (docs/scenes.md)."""

import argparse
import collections
import dataclasses
import io
import json
import multiprocessing
import pathlib
import time

import numpy
import torch
import torch.nn.functional as F

import finder_export
import finder_measure
import safetensors
from finder_net import LAYERS, FinderNet, layers_from, multiplications
from finder_pictures import HEIGHT, WIDTH, Pictures
from learner import CHECKPOINT_S, Learner, keep_memory, seed_all
from recipe import one_cycle
from replicas import Replicas, has_half_numbers
from teller import Teller

MAKERS = 2  # processes that put pictures together
AHEAD = 4  # batches that are being made
CALIBRATION = 256
FIRST_CALIBRATION = 10**9  # number of a picture that no training comes to
MEASURED = 4  # times within a training


@dataclasses.dataclass(frozen=True)
class Recipe:
    layers: str = LAYERS
    seed: int = 0
    pictures: int = 200_000
    batch: int = 32
    parts: int = 2
    rate: float = 2e-3
    warm_up: float = 0.05
    decay: float = 1e-2
    hand_weight: float = 2.0  # in the loss, of what is hand

    def rate_at(self, share):
        return one_cycle(self.rate, self.warm_up, share)


class Trainer(Learner):
    def __init__(self, recipe, device):
        seed_all(recipe.seed)
        self.recipe, self.device, self.half = recipe, device, device == "cuda" or has_half_numbers()
        self.net = FinderNet(layers_from(recipe.layers)).to(device, memory_format=torch.channels_last)
        self.weights = torch.tensor([1.0, recipe.hand_weight, 1.0, 1.0, 1.0]).to(device)
        self.replicas = Replicas(self.net, self.loss_of, recipe.parts)
        self.optimizer = torch.optim.AdamW(self.net.parameters(), recipe.rate, weight_decay=recipe.decay)
        self.step = 0
        self.started_from = None  # what is known of the training whose net it began with

    @property
    def steps(self):
        return self.recipe.pictures // self.recipe.batch

    def loss_of(self, net, batch):
        pictures = torch.as_tensor(batch["picture"]).to(self.device).permute(0, 3, 1, 2).float().div_(255)
        with torch.autocast(self.device, torch.bfloat16, enabled=self.half):
            scores = net(pictures)
        wide = F.interpolate(scores.float(), size=(HEIGHT, WIDTH), mode="bilinear", align_corners=False)
        logs = F.log_softmax(wide, 1)
        logs = torch.cat([logs, torch.logaddexp(logs[:, 0], logs[:, 2])[:, None]], 1)  # of REST_OR_ARM
        loss = F.nll_loss(logs, torch.as_tensor(batch["classes"]).to(self.device).long(), self.weights)
        return loss, {"loss": loss.item()}

    def save(self, path):
        self.replicas.join_statistics()
        file = io.BytesIO()
        torch.save({"recipe": dataclasses.asdict(self.recipe), "net": self.net.state_dict(),
                    "optimizer": self.optimizer.state_dict(), "step": self.step, "started_from": self.started_from},
                   file)
        safetensors.write_aside(path, file.getvalue())

    @property
    def history(self):
        before = {"started_from": self.started_from} if self.started_from else {}
        return {"recipe": dataclasses.asdict(self.recipe), "pictures_seen": self.step * self.recipe.batch} | before

    def start_from(self, path):
        other = Trainer.load(path, self.device)
        self.net.load_state_dict(other.net.state_dict())
        self.started_from = other.history
        self.replicas.copy_all()

    @staticmethod
    def recipe_of(path):
        return Recipe(**torch.load(path, map_location="cpu")["recipe"])

    @staticmethod
    def load(path, device):
        state = torch.load(path, map_location=device)
        trainer = Trainer(Recipe(**state["recipe"]), device)
        trainer.net.load_state_dict(state["net"])
        trainer.optimizer.load_state_dict(state["optimizer"])
        trainer.replicas.copy_all()
        trainer.step, trainer.started_from = state["step"], state.get("started_from")
        return trainer


class Maker:
    """Puts pictures together in other processes: each is a function of seed and number."""

    def __init__(self, seed):
        self.seed = seed
        self.pool = multiprocessing.get_context("fork").Pool(MAKERS)

    def batches(self, size, first, count):
        waiting = collections.deque()
        for number in range(first, first + count + AHEAD):
            if number < first + count:
                of_batch = range(number * size, (number + 1) * size)
                waiting.append(self.pool.map_async(draw, [(self.seed, picture) for picture in of_batch]))
            if number >= first + AHEAD:
                pictures, classes = zip(*waiting.popleft().get())
                yield {"picture": numpy.stack(pictures), "classes": numpy.stack(classes)}


PICTURES = None  # of this process: set before others are forked, which share its memory


def draw(seed_and_number):
    return PICTURES.draw(numpy.random.default_rng(seed_and_number))


def train(trainer, maker, checkpoint, measurement):
    teller, saved = Teller(trainer, "pictures"), time.monotonic()
    for batch in maker.batches(trainer.recipe.batch, trainer.step, trainer.steps - trainer.step):
        teller.add(trainer.learn(batch))
        if time.monotonic() - saved > CHECKPOINT_S or trainer.step == trainer.steps:
            trainer.save(checkpoint)
            saved = time.monotonic()
        if measurement and trainer.step % max(1, trainer.steps // MEASURED) == 0 and trainer.step < trainer.steps:
            trainer.replicas.join_statistics()
            finder_measure.tell(measurement.figures(finder_measure.scores_of_net(trainer.net)))


def write_weights(trainer, maker, measurement, path):
    batch = next(maker.batches(CALIBRATION, FIRST_CALIBRATION // CALIBRATION, 1))
    net = trainer.net.to("cpu")
    pictures = torch.as_tensor(batch["picture"]).permute(0, 3, 1, 2).float() / 255
    extra = {name: json.dumps(value) for name, value in trainer.history.items()}
    tensors, metadata = finder_export.export(net, pictures, extra | {"seed": str(trainer.recipe.seed)})
    if measurement:
        figures = {"floats": measurement.figures(finder_measure.scores_of_net(net)), "int8": measurement.figures(
            lambda pictures: finder_export.integer_scores(tensors, metadata, pictures))}
        for title, values in figures.items():
            print(title, flush=True)
            finder_measure.tell(values)
        metadata["figures"] = json.dumps(figures)
    safetensors.write(path, tensors, metadata)


def parsed():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--photos", required=True, nargs="+", type=pathlib.Path, help="folders of photographed scenes")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="checkpoint, labels of what is measured")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="the weights")
    parser.add_argument("--program", help="graspdb, to measure")
    parser.add_argument("--frames", nargs="*", default=[], metavar="NAME",
                        help="sequences whose photoreal frames are learned from, too; the others are measured on")
    parser.add_argument("--start", type=pathlib.Path, help="a checkpoint of another training, to go on from its net")
    parser.add_argument("--sequences", help="a folder of sequences to measure on")
    parser.add_argument("--photoreal", help="its photoreal frames")
    for field in dataclasses.fields(Recipe):
        parser.add_argument(f"--{field.name.replace('_', '-')}", default=field.default, type=type(field.default))
    return parser.parse_args()


def main():
    global PICTURES  # pylint: disable=global-statement
    options = parsed()
    keep_memory()
    options.work.mkdir(parents=True, exist_ok=True)
    PICTURES = Pictures(options.photos, finder_measure.frames_of(options, options.frames))
    checkpoint = options.work / "checkpoint.pt"
    recipe = Recipe(**{field.name: getattr(options, field.name) for field in dataclasses.fields(Recipe)})
    if checkpoint.exists():
        recipe = Trainer.recipe_of(checkpoint)
    maker = Maker(recipe.seed)  # before there are threads, which are not forked
    measurement = None
    if options.photoreal:
        measurement = finder_measure.Photoreal(options, options.frames)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    trainer = Trainer.load(checkpoint, device) if checkpoint.exists() else Trainer(recipe, device)
    if options.start and not checkpoint.exists():
        trainer.start_from(options.start)
    layers = trainer.net.layers
    print(f"{len(PICTURES.fronts)} hands, {len(PICTURES.rooms)} rooms; {multiplications(layers, HEIGHT, WIDTH) / 1e6:.0f} million "
          f"multiplications, {sum(p.numel() for p in trainer.net.parameters())} numbers", flush=True)
    train(trainer, maker, checkpoint, measurement)
    write_weights(trainer, maker, measurement, options.out)


if __name__ == "__main__":
    main()
