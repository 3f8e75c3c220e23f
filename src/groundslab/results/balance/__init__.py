"""Forces with which plate, ground and joints resist, from element matrices alone."""
