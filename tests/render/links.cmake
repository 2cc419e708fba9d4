set(links capcon_reference)
