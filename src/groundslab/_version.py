"""The version of groundslab."""

__version__ = "0.1.0"
