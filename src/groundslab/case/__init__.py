"""Case files: TOML to Model and back, and cases made from drawings."""
