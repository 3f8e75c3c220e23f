"""The text of a small case with a comment, solved at once."""

from __future__ import annotations

TEXT = """\
# The comment of the user.
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "250 mm"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[[loads]]
kind = "uniform"
q = "10 kPa"

[mesh]
counts = [4, 3]
"""
