"""Links where a slab is punched: what a code asks of their perimeters, and where their legs are."""
