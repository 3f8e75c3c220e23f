"""Drawings of lines, circles and texts on layers, and the DXF files that hold them."""
