"""Slabs from and to the Structural Analysis Format, workbooks that programs for structures exchange."""

from groundslab.exchange.saf.reading.reader import SafCase, list_slabs, read_saf

__all__ = ["SafCase", "list_slabs", "read_saf"]
