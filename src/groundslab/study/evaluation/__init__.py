"""Tables, statistics and reliability made of the rows of a study."""
