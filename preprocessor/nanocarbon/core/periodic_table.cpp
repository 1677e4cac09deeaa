// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/periodic_table.h"

#include <array>
#include <cmath>
#include <utility>

namespace nanocarbon {
namespace {

struct Row {
  std::string_view symbol, name;
  double mass;  // standard atomic weight, or of the longest-lived isotope, g/mol
};

constexpr std::array<Row, 118> rows = {{{"H", "hydrogen", 1.008},
                                        {"He", "helium", 4.0026},
                                        {"Li", "lithium", 6.94},
                                        {"Be", "beryllium", 9.0122},
                                        {"B", "boron", 10.81},
                                        {"C", "carbon", 12.011},
                                        {"N", "nitrogen", 14.007},
                                        {"O", "oxygen", 15.999},
                                        {"F", "fluorine", 18.9984},
                                        {"Ne", "neon", 20.1797},
                                        {"Na", "sodium", 22.9898},
                                        {"Mg", "magnesium", 24.305},
                                        {"Al", "aluminium", 26.9815},
                                        {"Si", "silicon", 28.085},
                                        {"P", "phosphorus", 30.9738},
                                        {"S", "sulfur", 32.06},
                                        {"Cl", "chlorine", 35.45},
                                        {"Ar", "argon", 39.948},
                                        {"K", "potassium", 39.0983},
                                        {"Ca", "calcium", 40.078},
                                        {"Sc", "scandium", 44.9559},
                                        {"Ti", "titanium", 47.867},
                                        {"V", "vanadium", 50.9415},
                                        {"Cr", "chromium", 51.9961},
                                        {"Mn", "manganese", 54.938},
                                        {"Fe", "iron", 55.845},
                                        {"Co", "cobalt", 58.9332},
                                        {"Ni", "nickel", 58.6934},
                                        {"Cu", "copper", 63.546},
                                        {"Zn", "zinc", 65.38},
                                        {"Ga", "gallium", 69.723},
                                        {"Ge", "germanium", 72.63},
                                        {"As", "arsenic", 74.9216},
                                        {"Se", "selenium", 78.971},
                                        {"Br", "bromine", 79.904},
                                        {"Kr", "krypton", 83.798},
                                        {"Rb", "rubidium", 85.4678},
                                        {"Sr", "strontium", 87.62},
                                        {"Y", "yttrium", 88.9058},
                                        {"Zr", "zirconium", 91.224},
                                        {"Nb", "niobium", 92.9064},
                                        {"Mo", "molybdenum", 95.95},
                                        {"Tc", "technetium", 97.9072},
                                        {"Ru", "ruthenium", 101.07},
                                        {"Rh", "rhodium", 102.9055},
                                        {"Pd", "palladium", 106.42},
                                        {"Ag", "silver", 107.8682},
                                        {"Cd", "cadmium", 112.414},
                                        {"In", "indium", 114.818},
                                        {"Sn", "tin", 118.71},
                                        {"Sb", "antimony", 121.76},
                                        {"Te", "tellurium", 127.6},
                                        {"I", "iodine", 126.9045},
                                        {"Xe", "xenon", 131.293},
                                        {"Cs", "caesium", 132.9055},
                                        {"Ba", "barium", 137.327},
                                        {"La", "lanthanum", 138.9055},
                                        {"Ce", "cerium", 140.116},
                                        {"Pr", "praseodymium", 140.9077},
                                        {"Nd", "neodymium", 144.242},
                                        {"Pm", "promethium", 144.9128},
                                        {"Sm", "samarium", 150.36},
                                        {"Eu", "europium", 151.964},
                                        {"Gd", "gadolinium", 157.25},
                                        {"Tb", "terbium", 158.9254},
                                        {"Dy", "dysprosium", 162.5},
                                        {"Ho", "holmium", 164.9303},
                                        {"Er", "erbium", 167.259},
                                        {"Tm", "thulium", 168.9342},
                                        {"Yb", "ytterbium", 173.054},
                                        {"Lu", "lutetium", 174.9668},
                                        {"Hf", "hafnium", 178.49},
                                        {"Ta", "tantalum", 180.9479},
                                        {"W", "tungsten", 183.84},
                                        {"Re", "rhenium", 186.207},
                                        {"Os", "osmium", 190.23},
                                        {"Ir", "iridium", 192.217},
                                        {"Pt", "platinum", 195.084},
                                        {"Au", "gold", 196.9666},
                                        {"Hg", "mercury", 200.592},
                                        {"Tl", "thallium", 204.38},
                                        {"Pb", "lead", 207.2},
                                        {"Bi", "bismuth", 208.9804},
                                        {"Po", "polonium", 208.9824},
                                        {"At", "astatine", 209.9872},
                                        {"Rn", "radon", 222.0176},
                                        {"Fr", "francium", 223.0197},
                                        {"Ra", "radium", 226.0254},
                                        {"Ac", "actinium", 227.0277},
                                        {"Th", "thorium", 232.0377},
                                        {"Pa", "protactinium", 231.0359},
                                        {"U", "uranium", 238.0289},
                                        {"Np", "neptunium", 237.0482},
                                        {"Pu", "plutonium", 244.0642},
                                        {"Am", "americium", 243.0614},
                                        {"Cm", "curium", 247.0703},
                                        {"Bk", "berkelium", 247.0703},
                                        {"Cf", "californium", 251.0796},
                                        {"Es", "einsteinium", 252.083},
                                        {"Fm", "fermium", 257.0951},
                                        {"Md", "mendelevium", 258.0984},
                                        {"No", "nobelium", 259.101},
                                        {"Lr", "lawrencium", 262.11},
                                        {"Rf", "rutherfordium", 267.122},
                                        {"Db", "dubnium", 268.126},
                                        {"Sg", "seaborgium", 271.134},
                                        {"Bh", "bohrium", 270.133},
                                        {"Hs", "hassium", 269.1338},
                                        {"Mt", "meitnerium", 278.156},
                                        {"Ds", "darmastadtium", 281.165},
                                        {"Rg", "roentgenium", 281.166},
                                        {"Cn", "copernicium", 285.177},
                                        {"Nh", "nihonium", 286.182},
                                        {"Fl", "flerovium", 289.19},
                                        {"Mc", "moscovium", 289.194},
                                        {"Lv", "livermorium", 293.204},
                                        {"Ts", "tennessine", 293.208},
                                        {"Og", "oganesson", 294.214}}};

}  // namespace

std::string_view element_symbol(AtomicNumber z) { return rows[z - 1].symbol; }
std::string_view element_name(AtomicNumber z) { return rows[z - 1].name; }

std::optional<AtomicNumber> atomic_number_of_symbol(std::string_view symbol) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].symbol == symbol) return static_cast<AtomicNumber>(k + 1);
  return std::nullopt;
}

std::optional<AtomicNumber> atomic_number_of_name(std::string_view name) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].name == name) return static_cast<AtomicNumber>(k + 1);
  return std::nullopt;
}

std::optional<AtomicNumber> atomic_number_of_mass(double mass) {
  constexpr std::pair<double, AtomicNumber> isotopes[] = {{2.0141, 1}, {3.0160, 1}, {13.0034, 6}};
  for (const auto& [isotope, z] : isotopes)
    if (std::abs(mass - isotope) < 0.01) return z;
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (std::abs(rows[k].mass - mass) < std::abs(rows[nearest].mass - mass)) nearest = k;
  if (!(std::abs(rows[nearest].mass - mass) < 0.1)) return std::nullopt;
  return static_cast<AtomicNumber>(nearest + 1);
}

}  // namespace nanocarbon
