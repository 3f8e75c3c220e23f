"""Slabs from and to the Structural Analysis Format, workbooks that programs for structures exchange."""

from groundslab.case.saf.reading.reader import SafCase, read_saf

__all__ = ["SafCase", "read_saf"]
