#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trains a learned descriptor on our own pictures and writes its weights (scripts/learn.sh)."""

import argparse
import dataclasses
import io
import json
import pathlib
import time

import torch

import export
import losses
import safetensors
import starting_weights
from learner import CHECKPOINT_S, Learner, keep_memory, seed_all
from measure import Measurement, tell
from net import Body, Net, multiplications, planes_of
from recipe import Recipe
from replicas import Replicas, has_half_numbers
from shards import LABELS, Shards, batches, round_steps
from teller import Teller

CALIBRATION = 4096
ALL_MEASURED = 4  # times within a training
MAKING_LEAVES = 0.85  # of the processors' time, while shards are made beside

RECIPE_OPTIONS = ("layers", "size", "seed", "crops", "batch", "parts", "shard", "rate")


class Trainer(Learner):
    def __init__(self, recipe, device):
        seed_all(recipe.seed)
        self.recipe, self.device = recipe, device
        self.net = Net(Body(len(recipe.planes), recipe.net_layers(), recipe.size), recipe.size).to(device)
        self.net.body.to(memory_format=torch.channels_last)
        self.losses, self.half = losses.Losses(recipe.weights, device), device == "cuda" or has_half_numbers()
        self.replicas = Replicas(self.net, self.loss_of, recipe.parts)
        self.optimizer = torch.optim.AdamW(self.net.parameters(), recipe.rate, weight_decay=recipe.decay)
        self.round = self.step = 0
        self.started_from = None  # what is known of the weights it began with

    def loss_of(self, net, batch):
        truth = {name: torch.as_tensor(batch[name]).to(self.device) for name in LABELS}
        with torch.autocast(self.device, torch.bfloat16, enabled=self.half):
            out = net(planes_of(batch, self.recipe.planes, self.device))
        return self.losses(out, truth)

    def start_from(self, path, crops):
        starting_weights.put_into(self.net, self.recipe, path, crops)
        self.started_from = starting_weights.provenance(path)
        self.replicas.copy_all()

    @property
    def round_steps(self):
        return round_steps(self.recipe)

    @property
    def rounds(self):
        return max(1, round(self.recipe.crops / (self.round_steps * self.recipe.batch)))

    @property
    def steps(self):
        return self.rounds * self.round_steps

    def save(self, path, assets):
        file = io.BytesIO()
        torch.save({"recipe": self.recipe.json(), "net": self.net.state_dict(), "assets": assets,
                    "optimizer": self.optimizer.state_dict(), "round": self.round, "step": self.step,
                    "started_from": self.started_from}, file)
        safetensors.write_aside(path, file.getvalue())

    @staticmethod
    def load(path, device):
        state = torch.load(path, map_location=device)
        trainer = Trainer(Recipe.parse(state["recipe"]), device)
        trainer.net.load_state_dict(state["net"])
        trainer.optimizer.load_state_dict(state["optimizer"])
        trainer.replicas.copy_all()
        trainer.round, trainer.step, trainer.started_from = state["round"], state["step"], state.get("started_from")
        return trainer, state["assets"]


def train(trainer, shards, checkpoint, measurement):
    teller, saved = Teller(trainer, "crops"), time.monotonic()
    while trainer.round < trainer.rounds:
        held = shards.round(trainer.round, trainer.rounds)
        for batch in batches(held, trainer.recipe.batch, [trainer.recipe.seed, trainer.round]):
            teller.add(trainer.learn(batch))
        trainer.replicas.join_statistics()
        trainer.round += 1
        if time.monotonic() - saved > CHECKPOINT_S or trainer.round == trainer.rounds:
            trainer.save(checkpoint, shards.assets)
            saved = time.monotonic()
        if measurement and trainer.round < trainer.rounds and \
                trainer.round * ALL_MEASURED // trainer.rounds > (trainer.round - 1) * ALL_MEASURED // trainer.rounds:
            tell(measurement.of_net(trainer.net, trainer.recipe.planes, trainer.device))


def write_weights(trainer, shards, measurement, path):
    recipe, net = trainer.recipe, trainer.net.to("cpu")
    calibration = {name: shards.held[max(shards.held)][name][:CALIBRATION] for name in recipe.planes}
    before = trainer.started_from or {"assets": []}
    seen = {*shards.assets.items(), *((asset["name"], asset["hash"]) for asset in before["assets"])}
    extra = {"seed": str(recipe.seed), "crops_seen": str(trainer.step * recipe.batch),
             "assets": json.dumps([{"name": name, "hash": hashed} for name, hashed in sorted(seen)])}
    if trainer.started_from:
        extra["started_from"] = json.dumps(before)
    tensors, metadata = export.export(net, recipe, calibration, extra)
    if measurement:
        figures = measurement.of_net(net, recipe.planes)
        whole = measurement.of_codes(lambda samples: export.integer_codes(tensors, metadata, samples))
        figures.update({f"{name}, int8": values for name, values in whole.items()})
        tell(figures)
        metadata["figures"] = json.dumps(figures)
    export.write(path, tensors, metadata)


def measured_speed(recipe, device, batch, seconds=15):
    """Crops a second of a throwaway net."""
    trainer = Trainer(dataclasses.replace(recipe, crops=10 ** 12), device)
    trainer.learn(batch)
    start, steps = time.monotonic(), 0
    while time.monotonic() - start < seconds:
        trainer.learn(batch)
        steps += 1
    return steps * recipe.batch / (time.monotonic() - start)


def new_recipe(options):
    weights = {field.name: getattr(options, field.name) for field in dataclasses.fields(losses.Weights)}
    same = {name: getattr(options, name) for name in RECIPE_OPTIONS}
    recipe = Recipe(planes=tuple(options.planes.split(",")), weights=losses.Weights(**weights), **same)
    if not options.start:
        return recipe
    starting_weights.check_fits(options.start, recipe)
    return dataclasses.replace(recipe, first=starting_weights.first_unseen(options.start))


def new_trainer(recipe, options, shards, device):
    pictures = shards.round(0, 1)
    if options.minutes:
        speed = measured_speed(recipe, device, next(batches(pictures, recipe.batch, 0)))
        recipe = dataclasses.replace(recipe, crops=int(options.minutes * 60 * speed * MAKING_LEAVES))
        print(f"{speed:.0f} crops/s: {recipe.crops} crops in {options.minutes} minutes", flush=True)
    trainer = Trainer(recipe, device)
    if options.start:
        trainer.start_from(options.start, {name: pictures[0][name][:CALIBRATION] for name in recipe.planes})
    return trainer


def parsed():
    recipe = Recipe()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="graspdb")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="shards, checkpoint, what is measured")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="the weights")
    parser.add_argument("--config", help="of the samples")
    parser.add_argument("--sequences", help="a folder to measure on; none when absent")
    parser.add_argument("--photoreal", help="a folder of photoreal frames of theirs to measure on, too")
    parser.add_argument("--minutes", type=float, help="as many crops as this takes, instead of --crops")
    parser.add_argument("--start", type=pathlib.Path, help="weights to go on from, instead of random ones")
    parser.add_argument("--planes", default=",".join(recipe.planes))
    for name in RECIPE_OPTIONS:
        parser.add_argument(f"--{name}", default=getattr(recipe, name), type=type(getattr(recipe, name)))
    for field in dataclasses.fields(losses.Weights):
        parser.add_argument(f"--{field.name.replace('_', '-')}", default=field.default, type=float)
    return parser.parse_args()


def check_started_from(trainer, options):
    if options.start and (trainer.started_from or {}).get("sha256") != starting_weights.sha256(options.start):
        raise SystemExit(f"{options.work}: holds a training that did not start from {options.start}; start in another "
                         f"work folder")


def main():
    options = parsed()
    keep_memory()
    device = "cuda" if torch.cuda.is_available() else "cpu"
    checkpoint = options.work / "checkpoint.pt"
    trainer, assets = Trainer.load(checkpoint, device) if checkpoint.exists() else (None, {})
    recipe = trainer.recipe if trainer else new_recipe(options)
    shards = Shards(options.program, options.work, recipe.planes, recipe.shard, options.config, recipe.first)
    shards.assets = assets
    measurement = None
    if options.sequences:
        measurement = Measurement(options.program, options.work, options.sequences, options.photoreal)
    try:
        if trainer:
            check_started_from(trainer, options)
            print(f"goes on at {trainer.share:.0%}", flush=True)
        else:
            trainer = new_trainer(recipe, options, shards, device)
        layers, size = trainer.recipe.net_layers(), trainer.recipe.size
        print(f"{multiplications(layers, len(recipe.planes), size) / 1e6:.1f} million multiplications, "
              f"{sum(p.numel() for p in trainer.net.body.parameters())} numbers", flush=True)
        train(trainer, shards, checkpoint, measurement)
        if not shards.held:  # killed between the last checkpoint and the weights
            shards.round(trainer.rounds - 1, 0)
        write_weights(trainer, shards, measurement, options.out)
    finally:
        shards.close()


if __name__ == "__main__":
    main()
