"""The figures that a reader wants first, as data, as JSON and on the terminal."""
