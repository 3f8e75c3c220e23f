"""How results are shown and kept: terminal, JSON, VTU, archive, folder."""
