"""Files and folders: written all at once or not at all, and never in place of what is not ours."""
