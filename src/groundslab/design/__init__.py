"""Design: demands that know no code, the codes, the bars, and the checks that hold demands against resistances."""
