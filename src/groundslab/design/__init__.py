"""Values for design: design moments, reinforcement, punching, section cuts, tilt, envelopes."""
