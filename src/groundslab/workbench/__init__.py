"""The workbench: a local server that edits a case file, solves it while it is edited, and shows it in a browser."""
