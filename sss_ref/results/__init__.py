"""Result folders: written whole, read again, verified, compared."""
