# SPDX-License-Identifier: MIT
"""Measures a net on the frames of sequences: by retrieval, and by its own heads."""

import pathlib
import subprocess

import numpy
import torch

import retrieval
import safetensors
from net import planes_of

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


class Measurement:
    """Frames with truth and references, made once and kept in the work folder."""

    def __init__(self, program, folder, sequences, references=REFERENCES):
        folder = pathlib.Path(folder)
        frames, rows = folder / "frames.safetensors", folder / "references.safetensors"
        made(program, frames, ["--sequences", sequences])
        made(program, rows, ["--config", HERE / "references.toml", "--count", references])
        self.frames, _ = safetensors.read(frames)
        self.references, _ = safetensors.read(rows)
        self.truth = retrieval.labels_of(self.frames)
        self.labels = retrieval.labels_of(self.references)
        self.sequence = torch.as_tensor(numpy.array(self.frames["sequence"]))

    def of_codes(self, queries, references):
        answers = retrieval.answers_by_codes(queries, references, self.labels)
        return {name: self.figures(answer) for name, answer in answers.items()}

    def of_net(self, net, planes, device="cpu"):
        out = outputs_of(net, self.frames, planes, device)
        figures = self.of_codes(out["code"], codes_of(net, self.references, planes, device))
        figures["heads"] = self.figures(retrieval.answer_of_heads(out))
        return figures

    def figures(self, answer):
        return retrieval.summary(retrieval.errors(answer, self.truth), self.sequence)


def made(program, path, options):
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([str(program), "samples", *map(str, options), "--out", str(path)], check=True,
                       stdout=subprocess.DEVNULL)


def tell(figures):
    for name, values in figures.items():
        print(f"  {name:12} {retrieval.told(values)}", flush=True)
