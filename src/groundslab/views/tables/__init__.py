"""Tables of results for calculations: each module makes one or two; `views/tables/result_tables` puts them together."""
