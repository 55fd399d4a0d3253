// Hazard curves as OpenQuake and the USGS write them: one curve in each format has the same rates; several are refused with
// the list. The files are made up.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string complaint_of_file(const std::string& text, const HazardReading& reading = {}) {
  try {
    static_cast<void>(read_hazard(text, "h", reading));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

HazardCurve hazard_in_file(const std::string& text, const HazardReading& reading = {}) {
  return read_hazard(text, "h", reading);
}

/// Two sites; at the second one the last two probabilities are 0.
const std::string openquake_table =
    "lon,lat,depth,poe-0.1000000,poe-0.4000000,poe-0.6000000\n"
    "10.50000,45.00000,-0.10000,4.553861E-01,5.754043E-02,6.354517E-03\n"
    "-10.60000,45.00000,-0.10000,1.522632E-01,0.000000E+00,0.000000E+00\n";
const HazardSite first_site{.longitude = 10.5, .latitude = 45.0};
const std::vector<double> first_poes{4.553861E-01, 5.754043E-02, 6.354517E-03};

void expect_rates_of_first(const HazardCurve& found, double years = 1.0) {
  ASSERT_EQ(found.points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found.points[i].rate, -std::log1p(-first_poes[i]) / years);
  EXPECT_EQ(found.points[1].intensity, 0.4);
  EXPECT_EQ(found.years, years);
  ASSERT_TRUE(found.site);
  EXPECT_EQ(found.site->longitude, 10.5);
}

TEST(HazardTable, OfOpenQuakeIsReadInEachOfItsDialects) {
  struct Dialect {
    std::string line;
    std::string statistic;
  };
  for (const auto& [line, statistic] :
       {Dialect{R"(# source_model_tree_path=b1, gsim_tree_path=b1, investigation_time=1.0, imt="PGA")", "realisation"},
        Dialect{R"(# source_model_tree_path=('b1',), gsim_tree_path=('b1',), investigation_time=1.0, imt="PGA")",
                "realisation"},
        Dialect{"# investigation_time=1.0, imt=PGA", ""},
        Dialect{"# kind=mean, investigation_time=1.0, imt='PGA'", "mean"},
        Dialect{R"(#,,,,,"generated_by='OpenQuake engine 3.18.0', checksum=2107362341, kind='quantile-0.84', )"
                "investigation_time=1.0, imt='PGA'\"",
                "quantile-0.84"},
        Dialect{R"(,,,,,"generated_by=""OpenQuake"", kind=""mean"", investigation_time=1.0, imt=""PGA""")", "mean"}}) {
    SCOPED_TRACE(line);
    const HazardCurve found = hazard_in_file(line + '\n' + openquake_table, {.site = first_site});
    expect_rates_of_first(found);
    EXPECT_EQ(found.intensity, "pga_g");
    EXPECT_EQ(found.statistic, statistic);
    const HazardCurve second = hazard_in_file(line + "\r\n" + openquake_table, {.site = HazardSite{-10.6, 45.00001}});
    EXPECT_EQ(second.points[1].rate, 0.0);
    EXPECT_EQ(second.points[2].rate, 0.0);
  }
}

TEST(HazardTable, SaysWhatToChooseWhereItHasSeveralSites) {
  const std::string text = "# investigation_time=50, imt=\"SA(0.1)\"\n" + openquake_table;
  EXPECT_THAT(complaint_of_file(text),
              AllOf(HasSubstr("2 hazard curves"), HasSubstr("choose --site 10.5,45 or -10.6,45")));
  EXPECT_THAT(complaint_of_file(text, {.site = HazardSite{10.501, 45.0}}),
              AllOf(HasSubstr("--site = 10.501,45: is not in h"), HasSubstr("10.5,45 or -10.6,45")));
  EXPECT_EQ(hazard_in_file(text, {.measure = "sa_g[0.1]", .site = first_site}).intensity, "sa_g[0.1]");
  EXPECT_THAT(complaint_of_file(text, {.measure = "PGA", .site = first_site}),
              HasSubstr("--imt = PGA: is not in h; choose"));
  EXPECT_THAT(complaint_of_file(text, {.site = first_site, .statistic = "mean"}),
              HasSubstr("--statistic = mean: is not in h"));
  EXPECT_THAT(complaint_of_file(text, {.years = 10.0, .site = first_site}), HasSubstr("another time than --years 10"));
}

TEST(HazardTable, WithoutACommentNeedsMeasureAndTime) {
  EXPECT_THAT(complaint_of_file(openquake_table, {.site = first_site}),
              HasSubstr("does not name its intensity measure"));
  EXPECT_THAT(complaint_of_file(openquake_table, {.measure = "PGA", .site = first_site}),
              HasSubstr("time that is not stated"));
  expect_rates_of_first(hazard_in_file(openquake_table, {.years = 10.0, .measure = "PGA", .site = first_site}), 10.0);
}

TEST(HazardTable, OfVelocitiesIsInCentimetresPerSecond) {
  const HazardCurve found =
      hazard_in_file("# investigation_time=1.0, imt=\"PGV\"\nlon,lat,depth,poe-5,poe-100\n1,2,0,0.1,0.01\n");
  EXPECT_EQ(found.intensity, "pgv_m_s");
  EXPECT_EQ(found.points.back().intensity, 1.0);
}

// The USGS writes annual rates, and the measure is the name of the folder.
TEST(HazardTable, OfTheUsgsHasAnnualRates) {
  const std::string text =
      "name,lon,lat,0.00233,0.0105,1.13\n\"A, town\",-118.25,34.05,0.51,0.2,1.0e-4\nB,-117,34.05,0.5,0.2,0\n";
  const HazardCurve found = hazard_in_file(text, {.measure = "PGA", .site = HazardSite{-118.25, 34.05}});
  ASSERT_EQ(found.points.size(), 3U);
  EXPECT_EQ(found.points[0].rate, 0.51);
  EXPECT_EQ(found.points[2].rate, 1.0e-4);
  EXPECT_FALSE(found.years);
  EXPECT_THAT(complaint_of_file(text, {.measure = "PGA"}), HasSubstr("--site -118.25,34.05 or -117,34.05"));
  EXPECT_THAT(complaint_of_file(text, {.years = 50.0, .measure = "PGA", .site = HazardSite{-117, 34.05}}),
              HasSubstr("--years means nothing"));
}

TEST(HazardTable, IsRefusedWithLineAndValue) {
  const std::string line = "# investigation_time=1.0, imt=\"PGA\"\n";
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2,mmi\n1,2,0.1,0.01,3\n"),
              HasSubstr("line 2 = \"mmi\": is neither a place nor an intensity"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,0.2\n1,2,0.1,0.01\n"),
              HasSubstr("line 2 = \"0.2\": is of another kind"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\n1,2,0.1\n"),
              HasSubstr("line 3 = \"1,2,0.1\": has 3 fields, but the first line has 4"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\nx,2,0.1,0.1\n"),
              HasSubstr("line 3 = \"x\": is not a number"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\n1,2,1.1,0.1\n"),
              HasSubstr("line 3 = 1.1: is no probability"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-98.1,poe-196.2\n1,2,0.1,0.01\n"), HasSubstr("likely in cm/s2"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\n1,2,0.1,0.2\n"),
              HasSubstr("line 3 = 0.2: is above the number"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\n"), HasSubstr("has no line for a site"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat\n1,2\n"), HasSubstr("has no column of an intensity"));
  EXPECT_THAT(complaint_of_file(line + "lon,lat,poe-0.1,poe-0.2\n1,2,0.1,0.01\n1,2,0.1,0.01\n"),
              AllOf(HasSubstr("2 hazard curves"), HasSubstr("h, line 3 and h, line 4")));
}

std::string nrml_curves(const std::string& attributes,
                        const std::string& poes = "4.553861E-01 5.754043E-02 6.354517E-03") {
  return "<hazardCurves " + attributes + " investigationTime=\"1.0\">\n<IMLs>0.1 0.4\n0.6</IMLs>\n" +
         "<hazardCurve><gml:Point><gml:pos>10.5 45.0</gml:pos></gml:Point><poEs>" + poes +
         "</poEs></hazardCurve>\n</hazardCurves>\n";
}

std::string nrml_file(const std::string& content, const std::string& version = "0.4") {
  return "<?xml version='1.0' encoding='UTF-8'?>\n<nrml xmlns:gml=\"http://www.opengis.net/gml\" "
         "xmlns=\"http://openquake.org/xmlns/nrml/" +
         version + "\">\n" + content + "</nrml>\n";
}

TEST(HazardNrml, IsReadWithItsMeasureAndStatistic) {
  struct Case {
    std::string attributes, measure, statistic;
  };
  for (const auto& [attributes, measure, statistic] :
       {Case{R"(statistics="mean" IMT="PGA")", "pga_g", "mean"},
        Case{R"(statistics="quantile" quantileValue="0.840" IMT="SA" saPeriod="0.20" saDamping="5.0")", "sa_g[0.2]",
             "quantile-0.84"},
        Case{R"x(sourceModelTreePath="b1_b2" gsimTreePath="b1" IMT="SA(1.0)")x", "sa_g[1]", "b1_b2/b1"}}) {
    for (const std::string version : {"0.4", "0.5"}) {
      const HazardCurve found = hazard_in_file("\xEF\xBB\xBF" + nrml_file(nrml_curves(attributes), version));
      expect_rates_of_first(found);
      EXPECT_EQ(found.intensity, measure);
      EXPECT_EQ(found.statistic, statistic);
    }
  }
}

TEST(HazardNrml, CountsAllTextOfAnElement) {
  for (const char* poes : {"4.553861E-01 <!-- two more --> 5.754043E-02 6.354517E-03",
                           "4.553861E-01<!-- --> <!-- -->5.754043E-02 6.3545<!-- in a number -->17E-03",
                           "<![CDATA[4.553861E-01 5.754043E-02]]> 6.354517E-03"}) {
    SCOPED_TRACE(poes);
    const std::string text = nrml_file(nrml_curves("IMT=\"PGA\"", poes));
    expect_rates_of_first(hazard_in_file(text));
  }
  std::string text = nrml_file(nrml_curves("IMT=\"PGA\""));
  text.replace(text.find("0.1 0.4"), 7, "0.1 <!-- g -->0.4");
  expect_rates_of_first(hazard_in_file(text));
}

TEST(HazardNrml, ChoosesByMeasureAndStatistic) {
  const std::string text =
      nrml_file(nrml_curves(R"(statistics="mean" IMT="PGA")") +
                nrml_curves(R"(statistics="quantile" quantileValue="0.84" IMT="PGA")", "0.5 0.1 0.0") +
                nrml_curves(R"(statistics="mean" IMT="SA" saPeriod="1.0")", "0.4 0.1 0.0"));
  EXPECT_THAT(complaint_of_file(text), AllOf(HasSubstr("3 hazard curves"), HasSubstr("--imt PGA or SA(1.0)"),
                                             HasSubstr("--statistic mean or quantile-0.84")));
  EXPECT_THAT(complaint_of_file(text, {.measure = "PGA"}), HasSubstr("choose --statistic mean or quantile-0.84"));
  expect_rates_of_first(hazard_in_file(text, {.measure = "PGA", .statistic = "mean"}));
  EXPECT_EQ(hazard_in_file(text, {.statistic = "Quantile_0.840"}).points[0].rate, -std::log1p(-0.5));
  EXPECT_EQ(hazard_in_file(text, {.measure = "SA1P0"}).intensity, "sa_g[1]");
}

TEST(HazardNrml, IsRefusedWithItsLine) {
  EXPECT_THAT(complaint_of_file("<nrml"), HasSubstr("is not XML"));
  EXPECT_THAT(complaint_of_file(nrml_file("<hazardMap IMT=\"PGA\"/>\n")),
              HasSubstr("line 3 = hazardMap: is no hazard curve"));
  EXPECT_THAT(complaint_of_file(nrml_file(nrml_curves("IMT=\"PGA\"", "0.1 0.2"))),
              HasSubstr("line 6 = 2 poEs: do not fit 3 IMLs"));
  EXPECT_THAT(complaint_of_file(nrml_file(nrml_curves("IMT=\"PGA\"", "0.3 1.2 0.1"))),
              HasSubstr("line 6 = 1.2: is no probability"));
  EXPECT_THAT(complaint_of_file(nrml_file(nrml_curves("IMT=\"MMI\""))),
              HasSubstr("MMI: is no known intensity measure"));
  EXPECT_THAT(complaint_of_file(nrml_file(nrml_curves("IMT=\"SA\" saPeriod=\"1\" saDamping=\"2.0\""))),
              HasSubstr("another damping"));
  std::string without_time = nrml_file(nrml_curves("IMT=\"PGA\""));
  without_time.erase(without_time.find(" investigationTime"), 24);
  EXPECT_THAT(complaint_of_file(without_time), HasSubstr("time that is not stated"));
}

const std::string usgs_2014 = R"({"status": "success", "response": [
  {"metadata": {"longitude": -118.25, "latitude": 34.05, "imt": {"value": "SA0P2", "display": "0.2 s"},
                "xvalues": [0.0025, 0.1, 1.5]},
   "data": [{"component": "Fault", "yvalues": [0.1, 0.01, 0.0]}, {"component": "Total", "yvalues": [0.5, 0.03, 2e-5]}]}
]})";
const std::string usgs_2023 = R"({"request": {"longitude": -118.25, "latitude": 34.05}, "response": {"hazardCurves": [
  {"imt": {"value": "PGA"}, "data": [{"component": "Total", "values": {"xs": [0.0025, 0.1, 1.5], "ys": [0.6, 0.02, 0]}}]},
  {"imt": {"value": "SA0P2"}, "data": [
    {"component": "Total", "values": {"xs": [0.0025, 0.1, 1.5], "ys": [0.5, 0.03, 2e-5]}},
    {"component": "Grid", "values": {"xs": [0.0025, 0.1, 1.5], "ys": [0.1, 0.02, 0]}}]}
]}})";

TEST(HazardOfTheUsgs, IsReadInBothLayouts) {
  for (const std::string& text : {usgs_2014, usgs_2023}) {
    const HazardCurve found = hazard_in_file(text, {.measure = "SA(0.2)"});
    ASSERT_EQ(found.points.size(), 3U);
    EXPECT_EQ(found.intensity, "sa_g[0.2]");
    EXPECT_EQ(found.points[1].intensity, 0.1);
    EXPECT_EQ(found.points[1].rate, 0.03);
    EXPECT_EQ(found.points[2].rate, 2e-5);
    EXPECT_FALSE(found.years);
    ASSERT_TRUE(found.site);
    EXPECT_EQ(found.site->longitude, -118.25);
  }
  EXPECT_THAT(complaint_of_file(usgs_2023), HasSubstr("choose --imt PGA or SA0P2"));
  EXPECT_EQ(hazard_in_file(usgs_2014).intensity, "sa_g[0.2]");
}

TEST(HazardOfTheUsgs, IsReadWithItsListsBesideTheComponent) {
  const std::string text = R"({"response": [{"metadata": {"imt": {"value": "PGA"}},
    "data": [{"component": "Total", "xs": [0.1, 0.2], "ys": [0.1, 0.01]}]}]})";
  EXPECT_EQ(hazard_in_file(text).points[1].rate, 0.01);
}

TEST(HazardOfTheUsgs, IsRefusedWithItsPlace) {
  const auto with = [](const std::string& data) {
    return complaint_of_file(R"({"response": [{"metadata": {"imt": {"value": "PGA"}, "xvals": [0.1, 0.2]}, "data": [)" +
                             data + "]}]}");
  };
  EXPECT_THAT(complaint_of_file("{\"a\": 1,,}"), ::testing::StartsWith("h"));
  EXPECT_THAT(complaint_of_file("{\"a\": 1}"), HasSubstr("is no answer of the hazard service"));
  EXPECT_THAT(complaint_of_file("{\"response\": []}"), HasSubstr("has no hazard curve"));
  EXPECT_THAT(with(R"({"component": "Fault", "yvals": [0.1, 0.01]})"),
              HasSubstr("/response/0: has no component Total"));
  EXPECT_THAT(with(R"({"component": "Total"})"), HasSubstr("/response/0/data/0: has no intensities or no rates"));
  EXPECT_THAT(with(R"({"yvals": [0.1]})"), HasSubstr("/response/0/data/0/yvals = 1 rates: do not fit 2 intensities"));
  EXPECT_THAT(with(R"({"yvals": [0.1, "x"]})"), HasSubstr("/response/0/data/0/yvals/1 = \"x\": is not a number"));
  EXPECT_THAT(with(R"({"yvals": [0.1, 0.01]}, {"yvals": [0.1, 0.01]})"), HasSubstr("2 hazard curves"));
}

TEST(Hazard, OfTwoColumnsHasNothingToChoose) {
  const std::string text = "pga_g, rate\n0.1,1e-2\n0.2,1e-3\n";
  EXPECT_THAT(complaint_of_file(text, {.site = first_site}),
              HasSubstr("--site: chooses one of several curves, and h holds one"));
  EXPECT_THAT(complaint_of_file(text, {.statistic = "mean"}), HasSubstr("--statistic: chooses"));
}

}  // namespace
}  // namespace rocking
