"""Reinforced concrete: materials, and how sections bend once they crack."""
