"""One job for every row of a table, here, on a Dask cluster or as a Slurm array."""
