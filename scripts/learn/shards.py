# SPDX-License-Identifier: MIT
"""Training pictures, made while the net learns from earlier ones.

Shard k holds the SIZE samples from FIRST + k * SIZE on. Round r goes once, in a drawn order, through the shards
r ... r + HELD - 1, while shard r + HELD is made: each picture is seen HELD times, and all is a pure
function of seed and round, so that training goes on after a kill as if nothing had been.
"""

import json
import pathlib
import subprocess

import numpy

import safetensors

HELD = 3
LABELS = ("rotation", "angles", "joints")
SAMPLES_VERSION = "2"


def read_samples(path):
    """(tensors, metadata); those of another version of the program are no training pictures of this one."""
    tensors, metadata = safetensors.read(path)
    if metadata["format_version"] != SAMPLES_VERSION:
        raise SystemExit(f"{path}: format_version: expected {SAMPLES_VERSION}, found {metadata['format_version']}; "
                         f"start in another work folder")
    return tensors, metadata


class Shards:
    def __init__(self, program, folder, planes, size, config=None, first=0):
        self.command = ["nice", "-n", "5", str(program), "samples"] + (["--config", str(config)] if config else [])
        self.folder, self.planes, self.size, self.first = pathlib.Path(folder), planes, size, first
        self.folder.mkdir(parents=True, exist_ok=True)
        self.running = {}
        self.held = {}
        self.assets = {}

    def path(self, shard):
        return self.folder / f"shard{shard:05}.safetensors"

    def start(self, shard):
        if shard in self.held or shard in self.running or self.path(shard).exists():
            return
        self.running[shard] = subprocess.Popen(
            self.command + ["--first", str(self.number_of_first(shard)), "--count", str(self.size),
                            "--out", str(self.path(shard))],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def finish(self, shard):
        process = self.running.pop(shard, None)
        if process is None:
            return
        _, said = process.communicate()
        if process.returncode:
            raise SystemExit(f"graspdb samples: {said.decode().strip()[-1000:]}")

    def number_of_first(self, shard):
        return self.first + shard * self.size

    def check_is_ours(self, shard, tensors, metadata):
        wanted = (self.number_of_first(shard), self.size)
        found = (int(metadata["first"]), len(tensors["rotation"]))
        if found != wanted:
            raise SystemExit(f"{self.path(shard)}: expected samples from {wanted[0]} on, {wanted[1]} of them, found "
                             f"{found[0]}, {found[1]}; start in another work folder")

    def load(self, shard):
        self.start(shard)
        self.finish(shard)
        tensors, metadata = read_samples(self.path(shard))
        self.check_is_ours(shard, tensors, metadata)
        for asset in json.loads(metadata["assets"]):
            self.assets[asset["name"]] = asset["hash"]
        # Copied: the file is gone before the samples are.
        self.held[shard] = {name: numpy.array(tensors[name]) for name in (*self.planes, *LABELS)}

    def round(self, number, last):
        """The pictures of a round, while the shard that the next one adds is being made."""
        for shard in [old for old in self.held if old < number]:
            del self.held[shard]
        for old in self.folder.glob("shard*.safetensors"):
            if int(old.stem[5:]) < number:
                old.unlink()
        for shard in range(number, number + HELD):
            if shard not in self.held:
                self.load(shard)
        if number + 1 < last:
            self.start(number + HELD)
        return [self.held[shard] for shard in range(number, number + HELD)]

    def close(self):
        for process in self.running.values():
            process.terminate()
            process.wait()


def round_steps(recipe):
    """How many batches a round has."""
    return HELD * recipe.shard // recipe.batch


def batches(shards, size, seed):
    """Batches in a drawn order; what is left over is left out."""
    count = len(shards[0]["rotation"])
    order = numpy.random.default_rng(seed).permutation(count * len(shards))
    for start in range(0, len(order) - size + 1, size):
        picked = order[start:start + size]
        yield {name: gathered(shards, name, picked, count) for name in shards[0]}


def gathered(shards, name, picked, count):
    result = numpy.empty((len(picked), *shards[0][name].shape[1:]), shards[0][name].dtype)
    for i, shard in enumerate(shards):
        of_it = picked // count == i
        result[of_it] = shard[name][picked[of_it] % count]
    return result
