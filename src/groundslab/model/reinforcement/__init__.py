"""Reinforcement as it is described: the bars that are laid."""
