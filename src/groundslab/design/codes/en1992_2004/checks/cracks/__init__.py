"""Cracks by EN 1992-1-1 7.3: their widths step by step, least bars as the slab first cracks, restraint."""
