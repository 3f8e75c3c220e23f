"""Remarks on a case that is right: where its load cases act, their forces, and what may not be meant."""
