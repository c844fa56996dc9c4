# SPDX-License-Identifier: MIT
"""Gradients of a batch, worked out in parts by one thread each.

Two threads inside each operation wait for each other some hundred times a step: beside any other
program that is slower by a factor of 25, and alone by a fifth. These wait once a step.
"""

import concurrent.futures
import copy
import pathlib

import numpy
import torch


def has_half_numbers():
    """Whether this processor multiplies numbers of half the bits, at three times the speed. Others
    would do it by hand."""
    flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="ascii", errors="ignore")
    return "avx512_bf16" in flags


class Replicas:
    """`loss_of(net, batch)` gives the loss and its parts by name, of a batch of any size."""

    def __init__(self, net, loss_of, parts):
        self.net, self.loss_of = net, loss_of
        self.nets = [net] + [copy.deepcopy(net) for _ in range(parts - 1)]
        torch.set_num_threads(1)
        self.pool = concurrent.futures.ThreadPoolExecutor(parts, initializer=torch.set_num_threads, initargs=(1,))

    def learn(self, batch):
        """Puts the gradients into the net; gives the parts of the loss."""
        size = len(next(iter(batch.values()))) // len(self.nets)
        parts = [{name: values[i * size:(i + 1) * size] for name, values in batch.items()}
                 for i in range(len(self.nets))]
        results = list(self.pool.map(self.gradients, self.nets, parts))
        for i, parameter in enumerate(self.net.parameters()):
            parameter.grad = sum(gradients[i] for gradients, _ in results) / len(results)
        return {name: numpy.mean([told[name] for _, told in results]) for name in results[0][1]}

    def gradients(self, net, batch):
        net.train()
        loss, told = self.loss_of(net, batch)
        return torch.autograd.grad(loss, list(net.parameters())), told

    def spread(self):
        """After a step of the optimizer: the others have the same numbers."""
        with torch.no_grad():
            for net in self.nets[1:]:
                for to, parameter in zip(net.parameters(), self.net.parameters()):
                    to.copy_(parameter)

    def copy_all(self):
        for net in self.nets[1:]:
            net.load_state_dict(self.net.state_dict())

    def join_statistics(self):
        """Of batch norm, which each has seen of its own part only."""
        with torch.no_grad():
            for buffers in zip(*(net.buffers() for net in self.nets)):
                if buffers[0].is_floating_point():
                    mean = sum(buffers) / len(buffers)
                    for buffer in buffers:
                        buffer.copy_(mean)
