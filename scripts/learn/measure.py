# SPDX-License-Identifier: MIT
"""Measures a net on the frames of sequences: by retrieval, and by its own heads."""

import pathlib
import subprocess

import numpy
import torch

import retrieval
from net import planes_of
from shards import read_samples

HERE = pathlib.Path(__file__).resolve().parent
REFERENCES = 20_000
BATCH = 512


def in_batches(call, samples):
    count = len(samples["rotation"])
    return [call({name: numpy.array(samples[name][start:start + BATCH]) for name in samples})
            for start in range(0, count, BATCH)]


def codes_of(net, samples, planes, device="cpu"):
    """Codes of length 1, by the floating-point net."""
    net.eval()
    with torch.no_grad():
        parts = in_batches(lambda part: net(planes_of(part, planes, device))["code"].cpu(), samples)
    return torch.cat(parts)


def outputs_of(net, samples, planes, device="cpu"):
    net.eval()
    with torch.no_grad():
        parts = in_batches(lambda part: {name: values.cpu() for name, values
                                         in net(planes_of(part, planes, device)).items()}, samples)
    return {name: torch.cat([part[name] for part in parts]) for name in parts[0]}


class Frames:
    """Frames of sequences, or drawn pictures, with their truth."""

    def __init__(self, samples):
        self.samples = samples
        self.truth = retrieval.labels_of(samples)
        alone = numpy.zeros(len(samples["rotation"]), numpy.int32)
        self.sequence = torch.as_tensor(numpy.array(samples.get("sequence", alone)))

    def figures(self, answer):
        return retrieval.summary(retrieval.errors(answer, self.truth), self.sequence)


class Measurement:
    """Frames and references, made once and kept in the work folder. `described` are options that ask for
    descriptors beside the crops."""

    def __init__(self, program, folder, sequences=None, photoreal=None, references=REFERENCES, described=()):
        folder = pathlib.Path(folder)
        self.references = made(program, folder / "references.safetensors",
                               ["--config", HERE / "references.toml", "--count", references, *described])
        self.labels = retrieval.labels_of(self.references)
        self.frames = {}
        if not sequences:
            return
        of_sequences = ["--sequences", sequences, *described]
        self.frames[""] = Frames(made(program, folder / "frames.safetensors", of_sequences))
        if photoreal:
            self.frames["photoreal, "] = Frames(made(program, folder / "photoreal.safetensors",
                                                     [*of_sequences, "--photoreal", photoreal]))

    def of_codes(self, codes):
        """`codes` gives those of samples."""
        return self.of_queries({title: codes(frames.samples) for title, frames in self.frames.items()},
                               codes(self.references))

    def of_queries(self, queries, references):
        """The codes of all frames, by title, and of the references."""
        return {title + name: self.frames[title].figures(answer)
                for title, codes in queries.items()
                for name, answer in retrieval.answers_by_codes(codes, references, self.labels).items()}

    def of_net(self, net, planes, device="cpu"):
        outputs = {title: outputs_of(net, frames.samples, planes, device) for title, frames in self.frames.items()}
        figures = self.of_queries({title: out["code"] for title, out in outputs.items()},
                                  codes_of(net, self.references, planes, device))
        for title, out in outputs.items():
            figures[title + "heads"] = self.frames[title].figures(retrieval.answer_of_heads(out))
        return figures


def made(program, path, options):
    """The samples of that file, which is made if it is not there."""
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([str(program), "samples", *map(str, options), "--out", str(path)], check=True,
                       stdout=subprocess.DEVNULL)
    return read_samples(path)[0]


def tell(figures):
    for name, values in figures.items():
        print(f"  {name:23} {retrieval.told(values)}", flush=True)
