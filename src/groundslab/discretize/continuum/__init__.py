"""An elastic continuum as the kernels know it: the cells on which it bears the plate."""
