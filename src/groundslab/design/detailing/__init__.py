"""Bars as they are cut, lapped and bent: the positions of a bar list."""
