"""Figures, drawn by Matplotlib without a display."""
