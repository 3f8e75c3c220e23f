"""The line force along the edge: what it carries, and its pressure over a strip."""
