set(links capcon_serve capcon_image ${HTTPLIB} nlohmann_json::nlohmann_json)
