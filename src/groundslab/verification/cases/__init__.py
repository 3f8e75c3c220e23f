"""Published and analytic cases as data; groundslab.verify reads them."""
