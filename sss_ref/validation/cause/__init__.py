"""What explains a wrong stage, tried on its very pixels."""
