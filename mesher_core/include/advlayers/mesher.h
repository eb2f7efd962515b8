// Mesher: the loop over the layers, and the mesh in the end.
//
//     advlayers::RunContext context;
//     const advlayers::Model model = advlayers::read_file(context, "wing.step");
//     advlayers::Settings settings;
//     settings.size = 30.0;
//     settings.first_height = 7.0;
//     advlayers::Mesher mesher(context, model, settings);
//     while (const auto layer = mesher.next()) std::cout << layer->layer << '\n';
//     const advlayers::MeshResult mesh = mesher.result();
#pragma once

#include "advlayers/context.h"
#include "advlayers/model.h"
#include "advlayers/result.h"
#include "advlayers/settings.h"
#include "mesher/mesher.h"
