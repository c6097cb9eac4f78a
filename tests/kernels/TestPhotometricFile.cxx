// SPDX-License-Identifier: BSD-3-Clause
// IES LM-63 and EULUMDAT: what every form of the formats means.
#include <gtest/gtest.h>

#include "photometry/PhotometricFile.h"

using namespace kalos;

namespace
{
// The numbers of an IES file: verticals, horizontals, and I = 100 + C + angle / 10 (or what `candela` says).
struct Ies
{
  std::string version = "IESNA:LM-63-2002\n", tilt = "TILT=NONE\n", lumens = "5000", multiplier = "1", type = "1",
              units = "2", size = "0.6 1.2 0", ballast = "1 1";
  std::vector<double> vertical{0, 45, 90}, horizontal{0};
  std::function<double(double, double)> candela = [](double h, double v) { return 100 + h + v / 10; };

  std::string text() const
  {
    auto join = [](const std::vector<double>& values) {
      std::string line;
      for (double v : values)
        line += std::to_string(v) + " ";
      return line + "\n";
    };
    std::string all = this->version + "[LUMINAIRE] Test lamp\n" + this->tilt + "2 " + this->lumens + " " +
                      this->multiplier + " " + std::to_string(this->vertical.size()) + " " +
                      std::to_string(this->horizontal.size()) + " " + this->type + " " + this->units + " " +
                      this->size + "\n" + this->ballast + " 50\n" + join(this->vertical) + join(this->horizontal);
    for (double h : this->horizontal)
    {
      std::vector<double> row;
      for (double v : this->vertical)
        row.push_back(this->candela(h, v));
      all += join(row);
    }
    return all;
  }
  PhotometricFile parse() const { return parsePhotometry(this->text()); }
};

std::string codes(const PhotometricFile& file)
{
  std::string all;
  for (const PhotometryWarning& w : file.warnings)
    all += w.code + ";";
  return all;
}

// An EULUMDAT text; I = 50 + (C + angle) / 10 in cd/klm over the planes that the symmetry leaves.
std::string eulumdat(int symmetry, const std::string& lampSets = "1\n1\nlamp\n2000\n4000\n80\n20\n")
{
  std::string text = "Company\n1\n" + std::to_string(symmetry) + "\n8\n45\n3\n45\nreport\nTest lamp\n7\nfile\ndate\n" +
                     "1200\n300\n60\n1150\n250\n0\n0\n0\n0\n100\n0\n1.0\n0\n" + lampSets;
  for (int i = 0; i < 10; ++i)
    text += "0.5\n";
  for (int c = 0; c < 360; c += 45)
    text += std::to_string(c) + "\n";
  text += "0\n45\n90\n";
  std::vector<int> planes;
  if (symmetry == 0)
    planes = {0, 45, 90, 135, 180, 225, 270, 315};
  if (symmetry == 1)
    planes = {0};
  if (symmetry == 2)
    planes = {0, 45, 90, 135, 180};
  if (symmetry == 3)
    planes = {270, 315, 0, 45, 90};
  if (symmetry == 4)
    planes = {0, 45, 90};
  for (int c : planes)
    for (int g : {0, 45, 90})
      text += std::to_string(50 + (c + g) / 10.0) + "\n";
  return text;
}
}  // namespace

TEST(Ies, versions)
{
  Ies ies;
  EXPECT_EQ(ies.parse().format, "IES LM-63-2002");
  EXPECT_EQ(ies.parse().name, "Test lamp");
  for (const auto& [line, format] : {std::pair{"", "IES LM-63-1986"},
                                     {"IESNA91\n", "IES LM-63-1991"},
                                     {"IESNA:LM-63-1995\n", "IES LM-63-1995"},
                                     {"IES:LM-63-2019\n", "IES LM-63-2019"}})
  {
    ies.version = line;
    EXPECT_EQ(ies.parse().format, format);
    EXPECT_EQ(codes(ies.parse()), "");
  }
  ies.version = "IESNA:LM-63-2050\n";
  EXPECT_EQ(codes(ies.parse()), "ies-version;");
}

TEST(Ies, horizontalRanges)
{
  Ies ies;
  auto reads = [&](std::vector<double> horizontal, std::vector<std::pair<double, double>> expected) {
    ies.horizontal = std::move(horizontal);
    const PhotometricFile file = ies.parse();
    EXPECT_DOUBLE_EQ(file.table.planes().back() - file.table.planes().front(), 360);
    for (const auto& [plane, equals] : expected)
      for (double angle : {0.0, 20.0, 45.0, 80.0, 90.0})
        EXPECT_NEAR(file.table.intensity(plane, angle), 100 + equals + angle / 10, 1e-9) << plane << " " << angle;
    EXPECT_EQ(file.table.intensity(0, 91), 0);
    return codes(file);
  };
  EXPECT_EQ(reads({0}, {{0, 0}, {77, 0}, {270, 0}}), "");
  EXPECT_EQ(reads({0, 30, 90}, {{10, 10}, {170, 10}, {190, 10}, {350, 10}, {90, 90}}), "");
  EXPECT_EQ(reads({0, 60, 180}, {{10, 10}, {350, 10}, {120, 120}, {240, 120}}), "");
  EXPECT_EQ(reads({90, 180, 270}, {{100, 100}, {80, 100}, {180, 180}, {0, 180}, {260, 260}, {280, 260}}), "");
  EXPECT_EQ(reads({-90, 0, 90}, {{10, 10}, {170, 10}, {-30, -30}, {210, -30}}), "");
  EXPECT_EQ(reads({180, 270, 360}, {{190, 190}, {170, 190}, {350, 350}, {10, 350}}), "");

  EXPECT_EQ(reads({0, 90, 180, 270, 360}, {{100, 100}, {300, 300}}), "ies-seam;");
  EXPECT_EQ(reads({0, 90, 180, 270}, {{100, 100}, {315, 135}}), "ies-range;");
  EXPECT_EQ(reads({180, 90, 0}, {{10, 10}, {350, 10}}), "ies-reversed;");
}

TEST(Ies, verticalRanges)
{
  Ies ies;
  ies.vertical = {90, 120, 180};
  EXPECT_EQ(codes(ies.parse()), "");
  EXPECT_EQ(ies.parse().table.intensity(0, 89), 0);
  EXPECT_NEAR(ies.parse().table.intensity(0, 100), 110, 1e-9);
  ies.vertical = {10, 45, 90};
  EXPECT_EQ(codes(ies.parse()), "ies-range;");
}

// Type A: C = H, gamma = V + 90. Type B: planes V about the axis along C = 90, from the axis towards C = 0.
TEST(Ies, typesAAndB)
{
  Ies ies;
  ies.type = "3";
  ies.vertical = {-90, 0, 90};
  ies.horizontal = {-90, 0, 90};
  const PhotometricFile a = ies.parse();
  EXPECT_NEAR(a.table.intensity(Vec3{1, 0, 0}), 100, 1e-9);
  EXPECT_NEAR(a.table.intensity(Vec3{0, 1, 0}), 190, 1e-9);
  EXPECT_NEAR(a.table.intensity(45, 170), 153, 1e-9);
  EXPECT_EQ(a.table.intensity(Vec3{-1, 0, 0}), 0);
  ies.type = "2";
  ies.candela = [](double h, double v) { return 200 + h + v / 10; };
  const PhotometricFile b = ies.parse();
  const double h = 20 * pi / 180, v = 35 * pi / 180;
  EXPECT_NEAR(b.table.intensity(Vec3{std::cos(h) * std::sin(v), std::sin(h), std::cos(h) * std::cos(v)}), 223.5, 1e-9);
  EXPECT_NEAR(b.table.intensity(Vec3{std::cos(h) * std::sin(v), -std::sin(h), std::cos(h) * std::cos(v)}), 183.5, 1e-9);
  ies.horizontal = {0, 45, 90};  // symmetric
  EXPECT_NEAR(ies.parse().table.intensity(Vec3{std::cos(h) * std::sin(v), -std::sin(h), std::cos(h) * std::cos(v)}),
              223.5, 1e-9);
  ies.horizontal = {0};
  EXPECT_THROW(ies.parse(), PhotometryError);
}

TEST(Ies, factors)
{
  Ies ies;
  ies.multiplier = "2";
  ies.ballast = "0.5 0.8";
  EXPECT_NEAR(ies.parse().table.intensity(0, 0), 80, 1e-9);
  EXPECT_EQ(codes(ies.parse()), "ies-future-use;");
  ies.version = "IESNA91\n";
  EXPECT_EQ(codes(ies.parse()), "");
  ies.version = "IES:LM-63-2019\n";  // the field tells how the file came about
  EXPECT_NEAR(ies.parse().table.intensity(0, 0), 100, 1e-9);
  EXPECT_EQ(ies.parse().lampFlux, 10000);
  ies.lumens = "-1";
  EXPECT_EQ(ies.parse().lampFlux, 0);
  ies.lumens = "10";
  EXPECT_EQ(codes(ies.parse()), "ies-flux;");
  ies.lumens = "0";
  EXPECT_EQ(codes(ies.parse()), "ies-lamp-lumens;");
}

TEST(Ies, openings)
{
  Ies ies;
  EXPECT_FALSE(ies.parse().opening.round);
  EXPECT_DOUBLE_EQ(ies.parse().opening.alongC90, 0.6);
  EXPECT_DOUBLE_EQ(ies.parse().opening.alongC0, 1.2);
  ies.units = "1";
  EXPECT_DOUBLE_EQ(ies.parse().opening.alongC0, 1.2 * 0.3048);
  ies.size = "-1 0 0";
  EXPECT_TRUE(ies.parse().opening.round);
  EXPECT_DOUBLE_EQ(ies.parse().opening.alongC0, 0.3048);
  ies.size = "0 0 0";
  EXPECT_TRUE(ies.parse().opening.isPoint());
}

TEST(Ies, tilt)
{
  Ies ies;
  EXPECT_EQ(ies.parse().tiltFactor(30), 1);
  ies.tilt = "TILT=INCLUDE\n1\n3\n0 20 40\n1 0.9 0.7\n";
  EXPECT_NEAR(ies.parse().tiltFactor(30), 0.8, 1e-12);
  EXPECT_NEAR(ies.parse().tiltFactor(90), 0.7, 1e-12);
  ies.tilt = "TILT=lamp.tlt\n";
  EXPECT_THROW(ies.parse(), PhotometryError);
  PhotometryOptions options;
  options.findTilt = [](const std::string& name) {
    return name == "lamp.tlt" ? "1 2 0 90 1 0.5" : std::optional<std::string>();
  };
  EXPECT_NEAR(parsePhotometry(ies.text(), options).tiltFactor(45), 0.75, 1e-12);
}

TEST(Eulumdat, symmetries)
{
  auto reads = [](int symmetry, std::vector<std::pair<double, double>> expected) {
    const PhotometricFile file = parsePhotometry(eulumdat(symmetry));
    EXPECT_EQ(file.format, "EULUMDAT");
    EXPECT_EQ(codes(file), "");
    for (const auto& [plane, equals] : expected)
      for (double angle : {0.0, 20.0, 45.0, 90.0})
        EXPECT_NEAR(file.table.intensity(plane, angle), 2 * (50 + (equals + angle) / 10), 1e-9) << plane;
  };
  reads(0, {{0, 0}, {30, 30}, {270, 270}, {337.5, 157.5}});
  reads(1, {{0, 0}, {123, 0}});
  reads(2, {{30, 30}, {330, 30}, {180, 180}});
  reads(3, {{30, 30}, {150, 30}, {270, 270}, {225, 315}, {315, 315}, {180, 0}});
  reads(4, {{30, 30}, {150, 30}, {210, 30}, {330, 30}});
}

TEST(Eulumdat, lampSetsAndOpening)
{
  const std::string sets = "2\n1\nA\n2000\n4000\n80\n20\n-3\nB\n500\n4000\n80\n20\n";
  EXPECT_NEAR(parsePhotometry(eulumdat(1, sets)).table.intensity(0, 0), 100, 1e-9);
  PhotometryOptions second;
  second.lampSet = 2;
  const PhotometricFile file = parsePhotometry(eulumdat(1, sets), second);
  EXPECT_NEAR(file.table.intensity(0, 0), 25, 1e-9);
  EXPECT_EQ(codes(file), "ldt-negative-lamps;");
  EXPECT_EQ(file.lampFlux, 0);
  EXPECT_EQ(file.lampSets, 2);
  second.lampSet = 3;
  EXPECT_THROW(parsePhotometry(eulumdat(1, sets), second), PhotometryError);
  EXPECT_DOUBLE_EQ(file.opening.alongC90, 1.15);
  EXPECT_DOUBLE_EQ(file.opening.alongC0, 0.25);
}

TEST(Eulumdat, decimalCommas)
{
  std::string text = eulumdat(4);
  for (char& c : text)
    if (c == '.')
      c = ',';
  EXPECT_NEAR(parsePhotometry(text).table.intensity(30, 45), 2 * 57.5, 1e-9);
  EXPECT_EQ(codes(parsePhotometry(text)), "ldt-decimal-comma;");
}
