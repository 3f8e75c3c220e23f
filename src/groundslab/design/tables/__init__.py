"""Tables of results for calculations: each module makes one or two; `design/result_tables` puts them together."""
