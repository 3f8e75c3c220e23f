"""The server of the workbench: its routes, its security, its sessions."""
