set(links nlohmann_json::nlohmann_json capcon_image capcon_distributed)
