// SPDX-License-Identifier: BSD-3-Clause
// Spellings of photometric files that public ones have, beside what the standards or the formats' users mean by them.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "photometry/PhotometricFile.h"

using namespace kalos;

namespace
{
/// An IES file of one plane: 100, 80 and 10 cd at 0, 45 and 90 degrees.
struct Ies
{
  std::string header = "IESNA:LM-63-2002\n", tilt = "TILT=NONE", size = "0 0 0", future = "1", candela = "100 80 10";

  PhotometricFile parse() const
  {
    return parsePhotometry(this->header + "[TEST] none\n" + this->tilt + "\n1 -1 1 3 1 1 2 " + this->size + "\n1 " +
                           this->future + " 10\n0 45 90\n0\n" + this->candela + "\n");
  }
};

/// The lines of an EULUMDAT file of one plane and three angles, 2000 lm; as counted from 1 some may be changed.
std::string eulumdat(const std::map<int, std::string>& changes = {})
{
  std::vector<std::string> lines{"maker", "1",   "1", "1",   "0",   "3",   "45",   "report", "name", "number", "file",
                                 "date",  "600", "0", "100", "600", "0",   "0",    "0",      "0",    "0",      "100",
                                 "80",    "1",   "0", "1",   "1",   "LED", "2000", "3000",   "80",   "20"};
  lines.insert(lines.end(), 11, "0");
  for (const char* line : {"0", "45", "90", "100", "80", "10"})
    lines.emplace_back(line);
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (changes.count(static_cast<int>(i) + 1) ? changes.at(static_cast<int>(i) + 1) : lines[i]) + "\n";
  return text;
}

std::string codes(const PhotometricFile& file)
{
  std::string all;
  for (const PhotometryWarning& w : file.warnings)
    all += w.code + ";";
  return all;
}

std::string errorOf(const std::string& text)
{
  try
  {
    parsePhotometry(text);
  }
  catch (const PhotometryError& error)
  {
    return error.what();
  }
  return "none";
}
}  // namespace

/// LM-63-1995 and LM-63-2002, table of luminous shapes: width, length, height; C0 runs along the length.
TEST(PhotometryDialects, ShapesOfLuminousOpenings)
{
  const struct
  {
    const char* size;
    double alongC0, alongC90;
    bool round, told;
  } shapes[] = {{"0 0 0", 0, 0, false, false},
                {"0.6 1.2 0", 1.2, 0.6, false, false},
                {"0.6 1.2 0.1", 1.2, 0.6, false, false},
                {"-0.5 0 0", 0.5, 0.5, true, false},
                {"-0.5 -0.5 0", 0.5, 0.5, true, false},
                {"-0.5 0 -0.5", 0.5, 0.5, true, false},
                {"0 1.2 -0.034", 1.2, 0.034, false, true},
                {"1.2 0 -0.034", 0.034, 1.2, false, true},
                {"-0.034 1.2 -0.034", 1.2, 0.034, false, false},
                {"0 1.2 0", 1.2, 0.0012, false, true},
                {"1.2 0 0", 0.0012, 1.2, false, true},
                {"0 -0.3 -0.3", 0.3, 0.0003, false, true}};
  for (const auto& shape : shapes)
  {
    Ies ies;
    ies.size = shape.size;
    const PhotometricFile file = ies.parse();
    EXPECT_NEAR(file.opening.alongC0, shape.alongC0, 1e-12) << shape.size;
    EXPECT_NEAR(file.opening.alongC90, shape.alongC90, 1e-12) << shape.size;
    EXPECT_EQ(file.opening.round, shape.round) << shape.size;
    EXPECT_EQ(codes(file), shape.told ? "ies-opening;" : "") << shape.size;
  }
}

/// LM-63-2019 has the type of the file's generation where earlier ones had a factor: it never multiplies.
TEST(PhotometryDialects, HeadersInAnySpelling)
{
  for (const char* header :
       {"IES:LM-63-2019\n", "\nIES:LM-63-2019\n", "  ies:lm-63-2019\n", "IESNA:LM-63-2019\n", "IES LM-63-2019\n",
        "IESNA: LM-63-2019 \n", "IES:LM-63-2019 (generated)\n", "IES:LM63-2019\n"})
  {
    Ies ies;
    ies.header = header;
    ies.future = "1.10000";
    EXPECT_EQ(ies.parse().format, "IES LM-63-2019") << header;
    EXPECT_DOUBLE_EQ(ies.parse().table.intensity(0, 0), 100) << header;
    EXPECT_EQ(codes(ies.parse()), "") << header;
  }
  Ies old;
  old.future = "1.1";
  EXPECT_DOUBLE_EQ(old.parse().table.intensity(0, 0), 110);
}

TEST(PhotometryDialects, TiltInAnyCase)
{
  for (const char* tilt : {"TILT=NONE", "tilt=none", "Tilt = None", "TILT= none "})
  {
    Ies ies;
    ies.tilt = tilt;
    EXPECT_DOUBLE_EQ(ies.parse().table.intensity(0, 45), 80) << tilt;
  }
}

/// A comma parts numbers, but where that leaves numbers over and decimal commas do not.
TEST(PhotometryDialects, CommasInIes)
{
  const std::tuple<const char*, double, double, const char*> rows[] = {
      {"100,5 80,2 10,1", 100.5, 80.2, "ies-decimal-comma;"},
      {"100,80,10", 100, 80, ""},
      {"100, 80, 10", 100, 80, ""},
      {"100.5,80.2,10.1", 100.5, 80.2, ""}};
  for (const auto& [candela, first, second, told] : rows)
  {
    Ies ies;
    ies.candela = candela;
    EXPECT_DOUBLE_EQ(ies.parse().table.intensity(0, 0), first) << candela;
    EXPECT_DOUBLE_EQ(ies.parse().table.intensity(0, 45), second) << candela;
    EXPECT_EQ(codes(ies.parse()), told) << candela;
  }
}

TEST(PhotometryDialects, NumbersOfEulumdat)
{
  const std::tuple<const char*, double, const char*> fluxes[] = {{"2000", 2000, ""},
                                                                 {"2 000", 2000, "ldt-digit-groups;"},
                                                                 {"12 000", 12000, "ldt-digit-groups;"},
                                                                 {"2000 lm", 2000, ""},
                                                                 {"2000,5", 2000.5, "ldt-decimal-comma;"}};
  for (const auto& [flux, lumens, told] : fluxes)
  {
    const PhotometricFile file = parsePhotometry(eulumdat({{29, flux}, {23, "0"}}));
    EXPECT_DOUBLE_EQ(file.lampFlux, lumens) << flux;
    EXPECT_DOUBLE_EQ(file.table.intensity(0, 0), 100 * lumens / 1000) << flux;
    EXPECT_EQ(codes(file), told) << flux;
  }
  EXPECT_EQ(errorOf(eulumdat({{29, "2000 4000"}})),
            "line 29: luminous flux of lamp set 1: found \"2000 4000\"; expected one number");
}

/// What users of the format leave out when it is 0 is 0; what counts is asked for by its own line.
TEST(PhotometryDialects, BlankNumbersOfEulumdat)
{
  for (int line : {5, 7, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 25, 33, 42})
  {
    const PhotometricFile file = parsePhotometry(eulumdat({{line, ""}, {23, ""}}));
    EXPECT_DOUBLE_EQ(file.table.intensity(0, 45), 160) << line;
    EXPECT_DOUBLE_EQ(file.opening.alongC90, line == 16 ? 0 : 0.6) << line;
    EXPECT_EQ(codes(file), "ldt-blank;") << line;
  }
  for (const auto& [line, field] : {std::pair{2, "type indicator"},
                                    {3, "symmetry"},
                                    {4, "number of C planes"},
                                    {6, "number of angles G"},
                                    {24, "conversion factor"},
                                    {26, "number of lamp sets"},
                                    {27, "number of lamps of lamp set 1"},
                                    {29, "luminous flux of lamp set 1"}})
    EXPECT_EQ(errorOf(eulumdat({{line, ""}})),
              "line " + std::to_string(line) + ": " + field + ": blank; expected a number");
  EXPECT_EQ(errorOf(eulumdat({{48, ""}})),
            "line 49: candela of plane C0 3 of 3: the file ends before it, and line 48 is blank; expected a number");
}
