"""Pictures by the thousand: a sweep of a scene's keys, rendered item by item, each written whole or not at all."""
