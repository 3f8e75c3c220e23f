"""Files for other programs: made of results, or of a case that has none."""
