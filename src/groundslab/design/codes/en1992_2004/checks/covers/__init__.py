"""The cover of bars by EN 1992-1-1, and their distance from heated faces by EN 1992-1-2."""
