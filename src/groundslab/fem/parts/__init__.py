"""What a problem is made of: frozen values of arrays."""
