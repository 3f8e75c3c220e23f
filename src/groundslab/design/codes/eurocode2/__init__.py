"""What both generations of EN 1992-1-1 share: steel, files of annexes, struts, cracked sections and their bars."""
