"""Makes things go wrong in a run of the lab experiment and judges the run by the simulator's ground truth."""
