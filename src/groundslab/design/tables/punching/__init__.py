"""What punches at columns and piles: loads inside perimeters, demands by each code, and what tables tell of them."""
