"""What a correct processor may have written, stage by stage."""
