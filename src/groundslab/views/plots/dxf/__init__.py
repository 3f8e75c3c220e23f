"""Plans of results as drawings (DXF)."""
