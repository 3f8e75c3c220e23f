"""Tables of the structure: columns, walls, beams, the building above."""
