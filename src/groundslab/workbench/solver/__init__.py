"""The process that solves the edited case, and the thread that looks after it."""
