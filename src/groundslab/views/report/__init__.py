"""The report: one HTML file that holds all of a solved model, opens without a network, and prints."""

from __future__ import annotations

from groundslab.views.report.changes import changes_since, text_of
from groundslab.views.report.html import check, default_path, render_report, write_report

__all__ = ["changes_since", "check", "default_path", "render_report", "text_of", "write_report"]
