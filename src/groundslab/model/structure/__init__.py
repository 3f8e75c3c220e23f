"""What stands on the plate: columns and walls."""
