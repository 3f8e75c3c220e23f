"""EN 1992-1-1:2023, the second generation, as rules by functions of arrays and floats.

The standard's text was not at hand. Formulas were read second hand: in Blueprints, which follows its formal draft
(chapter 8), in structuralcodes (sections 5, 9 and 12), and in public notes of someone who compared them with the
published text (henri421/blog). Where these differ, the last counts. docs/theory.md lists each formula with its source.
"""
