"""How input is described and checked: types of fields, the base class, issues and their wording, the reference."""
