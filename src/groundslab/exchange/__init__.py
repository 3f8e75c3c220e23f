"""Cases from and to the files of other programs: drawings, buildings, analysis models, tables of reactions."""
