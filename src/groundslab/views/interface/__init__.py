"""The JSON that groundslab has for other programs: its documents, and their shapes as JSON schemas."""
