#include "sim/material/tissue_looks.h"

#include <algorithm>

namespace fascia {

const std::vector<TissueLook>& tissue_looks() {
  // Columns: name, label; color, patches, lines; patch size, patchiness, share of lines, stretch, bumpiness, wetness,
  // scattering.
  static const std::vector<TissueLook> table = {
      {"flesh", "Flesh", {.68, .31, .27}, {.54, .20, .18}, {.82, .58, .48}, .20, .5, 0, 1, .10, .9, .6},
      {"liver", "Liver", {.52, .19, .15}, {.38, .11, .10}, {.62, .30, .22}, .16, .6, 0, 1, .10, 1, .5},
      {"kidney", "Kidney", {.56, .23, .19}, {.43, .14, .13}, {.64, .36, .29}, .14, .6, 0, 1, .08, 1, .5},
      {"spleen", "Spleen", {.44, .17, .20}, {.32, .10, .14}, {.52, .27, .28}, .14, .6, 0, 1, .10, 1, .5},
      {"brain", "Brain", {.80, .65, .60}, {.71, .52, .49}, {.60, .24, .24}, .20, .5, .15, 1, .10, .8, .7},
      {"gland", "Gland", {.80, .60, .50}, {.72, .47, .40}, {.86, .72, .58}, .10, .6, .2, 1, .25, .7, .7},
      {"fat", "Fat", {.87, .76, .52}, {.81, .65, .39}, {.72, .38, .30}, .16, .6, .15, 1, .28, .7, .9},
      {"muscle", "Muscle", {.56, .20, .18}, {.42, .12, .12}, {.74, .46, .41}, .10, .6, .2, 7, .22, .8, .5},
      {"vessel", "Vessel", {.70, .33, .30}, {.60, .25, .23}, {.82, .56, .50}, .16, .4, .1, 3, .06, .9, .7},
      {"skin", "Skin", {.83, .64, .54}, {.76, .53, .45}, {.70, .44, .40}, .20, .4, 0, 1, .14, .3, .7},
      {"cartilage", "Cartilage", {.80, .83, .83}, {.70, .75, .77}, {.88, .88, .86}, .24, .4, 0, 1, .04, .8, .6},
      {"tendon", "Tendon", {.86, .81, .73}, {.77, .69, .60}, {.93, .90, .84}, .10, .5, .3, 8, .16, .7, .5},
      {"bone", "Bone", {.86, .81, .71}, {.77, .69, .56}, {.68, .55, .44}, .16, .5, 0, 1, .16, .25, .2},
      {"tumor", "Tumor", {.78, .66, .56}, {.66, .43, .39}, {.56, .20, .21}, .12, .7, .2, 1, .32, .7, .6}};
  return table;
}

const TissueLook* find_look(std::string_view name) {
  const auto found = std::find_if(tissue_looks().begin(), tissue_looks().end(),
                                  [&](const TissueLook& look) { return name == look.name; });
  return found == tissue_looks().end() ? nullptr : &*found;
}

std::vector<std::string> look_names() {
  std::vector<std::string> names;
  for (const TissueLook& look : tissue_looks()) names.push_back(look.name);
  return names;
}

}  // namespace fascia
