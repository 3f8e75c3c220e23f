"""The page of a study: its figures, its tables and how they are written."""
