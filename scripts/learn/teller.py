# SPDX-License-Identifier: MIT
"""Tells how far a training is."""

import time

import numpy

TOLD_S = 20


class Teller:
    """Progress and time left, every TOLD_S seconds."""

    def __init__(self, trainer, unit):
        self.trainer, self.unit, self.first = trainer, unit, trainer.step
        self.start = self.last = time.monotonic()
        self.parts = []

    def add(self, parts):
        self.parts.append(parts)
        now = time.monotonic()
        if now - self.last < TOLD_S:
            return
        self.last = now
        trainer = self.trainer
        steps = trainer.step - self.first
        left = (trainer.steps - trainer.step) * (now - self.start) / steps
        means = "  ".join(f"{name} {numpy.mean([part[name] for part in self.parts]):.3f}" for name in parts)
        print(f"{trainer.share:6.1%}  {steps * trainer.recipe.batch / (now - self.start):.0f} {self.unit}/s  "
              f"{left / 60:.0f} min left  {means}", flush=True)
        self.parts = []
