"""Where the thickness of a plate changes: thinner slab on a perimeter, thicker zones that punch the slab around."""
