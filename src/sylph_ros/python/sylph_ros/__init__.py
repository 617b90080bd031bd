"""What programs and nodes of the suite share."""
