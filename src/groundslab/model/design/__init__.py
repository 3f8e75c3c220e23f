"""What the design is checked by: concrete and bars, limits, the strength of the soil, industrial floors."""
