"""The case file as it is edited: TOML with everything else kept, undo, issues with their lines."""
