# SPDX-License-Identifier: MIT
"""Linear forms, in which proofs express the contents of registers."""

from machine_code import Unprovable


class Form(dict):
    """A linear combination of variables; the key 1 is for the constant."""

    def __add__(self, other):
        total = Form(self)
        for name, factor in other.items():
            if value := total.get(name, 0) + factor:
                total[name] = value
            else:
                total.pop(name, None)
        return total

    def __sub__(self, other):
        return self + other * -1

    def __mul__(self, factor):
        return Form({name: factor * value for name, value in self.items()} if factor else {})

    def constant(self):
        if set(self) - {1}:
            raise Unprovable("a number that must be known depends on the operands")
        return self.get(1, 0)


def known(number):
    return Form({1: number} if number else {})
