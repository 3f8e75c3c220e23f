"""The files of a user: who has them open, and unsaved work."""
