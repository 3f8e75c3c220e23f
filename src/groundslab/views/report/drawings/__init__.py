"""Drawings of the report: the case in plan, its loads, the ground, fields in small plans; all as inline SVG."""
