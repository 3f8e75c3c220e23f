"""Industrial floors by yield lines and by strips on springs: TR34, Meyerhof, ACI 360R, PCA, and their checks."""
