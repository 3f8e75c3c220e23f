"""The design codes, each a folder of its rules, with what several of them share; registry.py has them by name."""
