"""Recording, replay and the report of a run."""
