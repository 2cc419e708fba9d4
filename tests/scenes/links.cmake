set(links capcon_scene)
