"""From what is described for serviceability to what the analysis knows: laws of cracked sections, softer ground."""
