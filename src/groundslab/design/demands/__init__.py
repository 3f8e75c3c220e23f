"""What acts on sections, perimeters and supports, without any code: forces, moments, lengths, places."""
