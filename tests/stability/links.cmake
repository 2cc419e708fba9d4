set(links capcon_render)
