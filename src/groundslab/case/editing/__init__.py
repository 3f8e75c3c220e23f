"""Edits of a TOML text in place, which keep comments and layout."""
