"""What an engineer describes: plate, ground, columns, supports, requested outputs, settings, and what must agree."""
