"""Checks of the ground: its bearing resistance, and what the line force along the edge carries."""
