"""The version of groundslab; between releases that of the next one, with .dev0."""

__version__ = "1.0.0.dev0"
