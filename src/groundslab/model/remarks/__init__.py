"""What is said of a case that is right: its load cases, their forces, singular places, what may not be meant."""
