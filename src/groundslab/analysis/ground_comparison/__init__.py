"""One slab on several models of its ground: each is compared with the elastic continuum, springs are fitted to it."""
