"""Cases as files in the Structural Analysis Format."""
