"""A comparison of grounds: its rows, and these on the terminal, as tables, as a figure and as files."""
