"""What files of other programs do not have, as comments of a case that are to be filled in."""

from __future__ import annotations

GROUND = (
    "# [ground]",
    '# kind = "vlasov"',
    "# [[ground.layers]]            # from the top downwards, as many as there are",
    '# E = "20 MPa"                # fill in',
    "# nu = 0.3                    # fill in",
    '# thickness = "2 m"           # fill in',
)
LOADS = (
    "# [[loads]]",
    '# kind = "uniform"',
    '# q = "6.25 kPa"              # fill in',
)
