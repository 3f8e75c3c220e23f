"""Drawings of bars on sheets of paper, to scale: one for each layer, for bars at edges, and for links."""
