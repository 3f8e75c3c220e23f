"""Cases with known answers, and how groundslab compares with them."""
