"""Runs variants, here or on Dask, and stores a row of each."""
