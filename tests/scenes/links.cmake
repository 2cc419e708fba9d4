set(links capcon_shading capcon_scenes)
