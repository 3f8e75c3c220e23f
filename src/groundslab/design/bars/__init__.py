"""Bars as they are laid, cut, lapped and bent: one by one, as the positions of a bar list, and in sums."""
