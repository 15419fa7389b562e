"""Where machine code and other slow results are kept between processes."""
