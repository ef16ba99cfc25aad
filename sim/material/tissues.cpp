#include "sim/material/tissues.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "sim/material/tissue_looks.h"

namespace fascia {
namespace {

/// For nearly incompressible tissue: the bulk modulus is then 3.3 times Young's modulus, and linear tets can still
/// deform.
constexpr double kSoft = 0.45;

std::string pascals(double value) {
  const char* unit = value >= 1e9 ? "GPa" : value >= 1e6 ? "MPa" : value >= 1e3 ? "kPa" : "Pa";
  const double scale = value >= 1e9 ? 1e9 : value >= 1e6 ? 1e6 : value >= 1e3 ? 1e3 : 1;
  char text[32];
  std::snprintf(text, sizeof text, "%.4g %s", value / scale, unit);
  return text;
}

}  // namespace

const std::vector<Tissue>& tissues() {
  static const std::vector<Tissue> table = {
      {"brain_gray", "Brain, gray matter", "brain", 1.4e3, kSoft, 1040, 0.5e3, 10e3,
       "bovine, fresh slices, flat-punch indentation, quasi-static (1.389 +- 0.289 kPa)",
       "Budday et al. 2015, Mechanical properties of gray and white matter brain tissue by indentation, J Mech Behav "
       "Biomed Mater 46"},
      {"brain_white", "Brain, white matter", "brain", 1.9e3, kSoft, 1040, 0.5e3, 10e3,
       "bovine, fresh slices, flat-punch indentation, quasi-static (1.895 +- 0.592 kPa)",
       "Budday et al. 2015, Mechanical properties of gray and white matter brain tissue by indentation, J Mech Behav "
       "Biomed Mater 46"},
      {"spleen", "Spleen", "spleen", 2.9e3, kSoft, 1060, 1e3, 20e3,
       "human, in vivo, shear-wave elastography, 127 volunteers (2.9 +- 1.8 kPa)",
       "Arda et al. 2011, Quantitative assessment of normal soft-tissue elasticity using shear-wave ultrasound "
       "elastography, Am J Roentgenol 197"},
      {"pancreas", "Pancreas", "gland", 4.8e3, kSoft, 1045, 1e3, 10e3,
       "human, in vivo, shear-wave elastography, 127 volunteers (4.8 +- 3 kPa)",
       "Arda et al. 2011, Quantitative assessment of normal soft-tissue elasticity using shear-wave ultrasound "
       "elastography, Am J Roentgenol 197"},
      {"kidney", "Kidney, cortex", "kidney", 5.0e3, kSoft, 1050, 2e3, 25e3,
       "human, in vivo, shear-wave elastography, 127 volunteers (5.0 +- 2.9 kPa)",
       "Arda et al. 2011, Quantitative assessment of normal soft-tissue elasticity using shear-wave ultrasound "
       "elastography, Am J Roentgenol 197"},
      {"liver", "Liver", "liver", 5.5e3, kSoft, 1060, 0.5e3, 8e3,
       "human, in vivo, transient elastography at 50 Hz (5.5 +- 1.6 kPa); slow compression of samples gives less",
       "Roulot et al. 2008, Liver stiffness values in apparently healthy subjects: influence of gender and metabolic "
       "syndrome, J Hepatol 48"},
      {"liver_indented", "Liver, indented", "liver", 12e3, 0.4, 1060, 10e3, 15e3,
       "pig, in vivo, static indentation during laparoscopy (10 to 15 kPa), as an instrument feels it; Poisson's ratio "
       "below the physical one, at which linear tets bend more freely",
       "Samur et al. 2007, A robotic indenter for minimally invasive measurement and characterization of soft tissue "
       "response, Med Image Anal 11"},
      {"thyroid", "Thyroid", "gland", 11e3, kSoft, 1050, 5e3, 25e3,
       "human, in vivo, shear-wave elastography, 127 volunteers (10.97 +- 3.1 kPa)",
       "Arda et al. 2011, Quantitative assessment of normal soft-tissue elasticity using shear-wave ultrasound "
       "elastography, Am J Roentgenol 197"},
      {"fat", "Fat, subcutaneous", "fat", 1.6e3, kSoft, 950, 0.5e3, 20e3,
       "human, ex vivo, initial slope of uniaxial tension (1.6 +- 0.8 kPa; stiffens tenfold towards 30 % strain)",
       "Alkhouli et al. 2013, The mechanical properties of human adipose tissues and their relationships to the "
       "structure and composition of the extracellular matrix, Am J Physiol Endocrinol Metab 305"},
      {"breast_fat", "Breast, fat", "fat", 3.25e3, kSoft, 950, 2e3, 20e3,
       "human, ex vivo, indentation with 4 % strain, quasi-static (3.25 +- 0.91 kPa)",
       "Samani, Zubovits, Plewes 2007, Elastic moduli of normal and pathological human breast tissues: an "
       "inversion-technique-based investigation of 169 samples, Phys Med Biol 52"},
      {"breast_gland", "Breast, gland", "gland", 3.24e3, kSoft, 1020, 2e3, 35e3,
       "human, ex vivo, indentation, quasi-static (3.24 +- 0.61 kPa); precompressed samples of others give 28 kPa",
       "Samani, Zubovits, Plewes 2007, Elastic moduli of normal and pathological human breast tissues: an "
       "inversion-technique-based investigation of 169 samples, Phys Med Biol 52"},
      {"breast_tumor", "Breast, carcinoma", "tumor", 42.5e3, kSoft, 1050, 10e3, 110e3,
       "human, ex vivo, invasive ductal carcinoma of high grade, indentation, quasi-static (42.5 +- 12.5 kPa)",
       "Samani, Zubovits, Plewes 2007, Elastic moduli of normal and pathological human breast tissues: an "
       "inversion-technique-based investigation of 169 samples, Phys Med Biol 52"},
      {"prostate", "Prostate", "gland", 55e3, kSoft, 1045, 15e3, 70e3,
       "human, ex vivo, anterior part, compression at 0.1 Hz, precompressed by 4 % (55 +- 14 kPa)",
       "Krouskop et al. 1998, Elastic moduli of breast and prostate tissues under compression, Ultrason Imaging 20"},
      {"muscle", "Muscle, at rest", "muscle", 11e3, kSoft, 1050, 5e3, 50e3,
       "human, in vivo, gastrocnemius, shear-wave elastography read as isotropic (11.1 +- 4.1 kPa); contracted muscle "
       "is much stiffer",
       "Arda et al. 2011, Quantitative assessment of normal soft-tissue elasticity using shear-wave ultrasound "
       "elastography, Am J Roentgenol 197"},
      {"heart_muscle", "Heart muscle, passive", "muscle", 18e3, kSoft, 1060, 5e3, 50e3,
       "rat, fresh, microindentation (18 +- 2 kPa); human values scatter widely",
       "Berry et al. 2006, Mesenchymal stem cell injection after myocardial infarction improves myocardial compliance, "
       "Am J Physiol Heart Circ Physiol 290"},
      {"cornea", "Cornea", "cartilage", 0.29e6, kSoft, 1050, 0.1e6, 1e6,
       "human, in vivo, from applanation tonometry (0.29 +- 0.06 MPa)",
       "Hamilton, Pye 2008, Young's modulus in normal corneas and the effect on applanation tonometry, Optom Vis Sci "
       "85"},
      {"sclera", "Sclera", "tendon", 1.8e6, kSoft, 1050, 1e6, 5e6,
       "human, ex vivo, posterior strips, tension (1.8 +- 1.1 MPa; anterior 2.9 +- 1.4)",
       "Friberg, Lace 1988, A comparison of the elastic properties of human choroid and sclera, Exp Eye Res 47"},
      {"artery", "Artery wall", "vessel", 0.75e6, kSoft, 1100, 0.2e6, 2e6,
       "human, in vivo, common carotid at physiological pressure, age 45 to 49 (means 0.70 MPa in women, 0.77 in men)",
       "Riley et al. 1992, Ultrasonic measurement of the elastic modulus of the common carotid artery (ARIC study), "
       "Stroke 23"},
      {"skin", "Skin", "skin", 1.2e6, kSoft, 1090, 5e3, 80e6,
       "human, excised from the back, initial slope of uniaxial tension (1.18 +- 0.88 MPa); indentation gives some "
       "kPa, strong tension 80 MPa",
       "Ni Annaidh et al. 2012, Characterization of the anisotropic mechanical properties of excised human skin, J "
       "Mech Behav Biomed Mater 5"},
      {"disc_nucleus", "Disc, nucleus pulposus", "cartilage", 0.27e6, kSoft, 1100, 0.05e6, 1e6,
       "human, lumbar, confined compression (aggregate modulus 1.01 +- 0.43 MPa, which is 0.27 MPa at this Poisson's "
       "ratio)",
       "Johannessen, Elliott 2005, Effects of degeneration on the biphasic material properties of human nucleus "
       "pulposus in confined compression, Spine 30"},
      {"disc_annulus", "Disc, annulus", "tendon", 4.2e6, kSoft, 1100, 0.5e6, 20e6,
       "ground substance of a finite element model fitted to discs in compression; its fibers, several hundred MPa, "
       "are apart",
       "Shirazi-Adl, Shrivastava, Ahmed 1984, Stress analysis of the lumbar disc-body unit in compression, Spine 9"},
      {"cartilage", "Cartilage, equilibrium", "cartilage", 0.68e6, 0.1, 1100, 0.3e6, 15e6,
       "human, femoral condyle, indentation creep at equilibrium (aggregate modulus 0.70 MPa, Poisson's ratio 0.10); "
       "at once, before the water leaves, some ten times stiffer and incompressible",
       "Athanasiou et al. 1991, Interspecies comparisons of in situ intrinsic mechanical properties of distal femoral "
       "cartilage, J Orthop Res 9"},
      {"ligament", "Ligament", "tendon", 332e6, kSoft, 1140, 50e6, 500e6,
       "human, medial collateral, ex vivo, along the fibers (332 +- 58 MPa); across them 11 MPa, which an isotropic "
       "material cannot have",
       "Quapp, Weiss 1998, Material characterization of human medial collateral ligament, J Biomech Eng 120"},
      {"tendon", "Tendon", "tendon", 1.2e9, kSoft, 1140, 0.4e9, 2e9,
       "human, in vivo, tibialis anterior, along the fibers under strong contraction (1.2 GPa)",
       "Maganaris, Paul 1999, In vivo human tendon mechanical properties, J Physiol 521"},
      {"bone_cancellous", "Bone, cancellous", "bone", 344e6, 0.3, 1180, 50e6, 4e9,
       "human, vertebra, ex vivo, on-axis compression and tension (344 +- 148 MPa); the femoral neck has ten times "
       "that",
       "Morgan, Keaveny 2001, Dependence of yield strain of human trabecular bone on anatomic site, J Biomech 34"},
      {"bone_cortical", "Bone, cortical", "bone", 17e9, 0.3, 1920, 10e9, 25e9,
       "human, femur, ex vivo, lengthwise tension (17.0 GPa; crosswise 11.5)",
       "Reilly, Burstein 1975, The elastic and ultimate properties of compact bone tissue, J Biomech 8"}};
  return table;
}

const Tissue* find_tissue(std::string_view name) {
  const auto found =
      std::find_if(tissues().begin(), tissues().end(), [&](const Tissue& tissue) { return name == tissue.name; });
  return found == tissues().end() ? nullptr : &*found;
}

std::vector<std::string> tissue_names() {
  std::vector<std::string> names;
  for (const Tissue& tissue : tissues()) names.push_back(tissue.name);
  return names;
}

void apply(const Tissue& tissue, Material& material) {
  material.young_modulus = tissue.young_modulus;
  material.poisson_ratio = tissue.poisson_ratio;
  material.density = tissue.density;
  material.look = find_look(tissue.look);
}

const Tissue* tissue_of(const Material& material) {
  const auto found = std::find_if(tissues().begin(), tissues().end(), [&](const Tissue& tissue) {
    return material.young_modulus == tissue.young_modulus && material.poisson_ratio == tissue.poisson_ratio &&
           material.density == tissue.density;
  });
  return found == tissues().end() ? nullptr : &*found;
}

std::string about(const Tissue& tissue) {
  std::string text = pascals(tissue.young_modulus) + ", a typical value of a wide range, " + pascals(tissue.least) +
                     " to " + pascals(tissue.most) + ". Measured: " + tissue.conditions + ".";
  if (tissue.poisson_ratio == kSoft)
    text += "\nPoisson's ratio 0.45 for linear tets, which lock above; 0.49 would be physical.";
  return text + "\n" + tissue.source + ".";
}

void print_tissues(std::ostream& out) {
  char line[160];
  std::snprintf(line, sizeof line, "%-16s %10s %6s %10s   %s\n", "preset", "E", "nu", "kg/m^3", "range of E");
  out << "Typical values of wide ranges, at small strain, isotropic. Where Poisson's ratio is 0.45, 0.49 would be "
         "physical, but linear\n"
         "tets lock there. Densities: ICRU Report 46 (1992), what it lacks after the IT'IS tissue properties "
         "database.\n\n"
      << line;
  for (const Tissue& tissue : tissues()) {
    const std::string range = pascals(tissue.least) + " to " + pascals(tissue.most);
    std::snprintf(line, sizeof line, "%-16s %10s %6g %10g   %s\n", tissue.name, pascals(tissue.young_modulus).c_str(),
                  tissue.poisson_ratio, tissue.density, range.c_str());
    out << line << "    " << tissue.conditions << "\n    " << tissue.source << '\n';
  }
}

}  // namespace fascia
