"""A page that shows a scene while it is changed: the picture is drawn here, the browser only shows it."""
