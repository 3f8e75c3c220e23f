"""The server for assistants (Model Context Protocol): check, solve, checks, tables and plots within one folder."""
