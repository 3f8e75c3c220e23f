"""Results as files: archives, VTK, and the folder that holds them."""
