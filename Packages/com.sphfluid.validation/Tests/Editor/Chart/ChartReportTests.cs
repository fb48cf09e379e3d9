using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The chart's page, from made-up runs: base and two κ of the corrected method, a base of the standard one, a printed one that fails.
    /// </summary>
    public sealed class ChartReportTests
    {
        private static readonly Regex dataIsland =
            new Regex("<script id=\"data\" type=\"application/json\">(.*?)</script>", RegexOptions.Singleline);
        private static readonly Regex codeAndStyle = new Regex("(<(script|style)[^>]*>).*?(</\\2>)", RegexOptions.Singleline);

        private string folder;

        [SetUp]
        public void SetUp()
        {
            folder = TestFolder.Fresh();
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void TearDown() => TestFolder.Delete(folder);

        private static int IndexOfStandard => CaseMethod.All.ToList().FindIndex(m => m.Name == "standard");

        [Test]
        public void ThePageIsWellFormedAndHasASectionForEachCase()
        {
            XmlDocument page =
                Parsed(Html(Report("A 'fast' <one>", new FlatCase("one") { Companion = "drift", Warning = "A & B" }, new FlatCase("two"))));

            Assert.That(page.SelectNodes("//section[@data-case]").Count, Is.EqualTo(2));
            Assert.That(page.SelectSingleNode("//section[@id='case-one']/h2").InnerText, Is.EqualTo("A cube's rest"));
            Assert.That(page.SelectSingleNode("//section[@id='case-one']/p[@class='caution']").InnerText, Is.EqualTo("A & B"));
            Assert.That(page.SelectSingleNode("//section[@id='case-two']/p[@class='caution']"), Is.Null);
            Assert.That(page.SelectSingleNode("//title").InnerText, Is.EqualTo("Error against GPU time: A 'fast' <one>"));
            Assert.That(page.SelectNodes("//nav//a").Cast<XmlElement>().Select(a => a.GetAttribute("href")),
                Is.EqualTo(new[] { "#case-one", "#case-two" }));
            Assert.That(page.SelectNodes("//*[@id]").Cast<XmlElement>().GroupBy(e => e.GetAttribute("id")).Where(g => g.Count() > 1)
                .Select(g => g.Key), Is.Empty, "ids are unique");
            string facts = page.SelectSingleNode("//dl[@class='facts']").InnerText;
            Assert.That(facts, Does.Contain("2026-11-21").And.Contain("22, of which 2 failed").And.Contain("chart --quick"));
        }

        [Test]
        public void ThePageNeedsNoOtherFile()
        {
            string html = Html(Report("device", new FlatCase("one")));

            Assert.That(Parsed(html).SelectNodes("//link | //img | //script[@src] | //iframe").Count, Is.Zero);
            Assert.That(html, Does.Not.Contain("@import").And.Not.Contain("fetch(").And.Not.Contain("{{").And.Not.Match("url\\((?!#)"));
            Assert.That(Regex.Matches(html, "https?://[^\"]*").Cast<Match>().Select(m => m.Value).Distinct(),
                Is.EqualTo(new[] { "http://www.w3.org/2000/svg" }), "a name, no address");
        }

        [Test]
        public void TheDataHasEveryPointWithItsBars()
        {
            Data data = DataOf(Html(Report("device", new FlatCase("one") { Companion = "drift" })));

            Assert.That(data.methods.Select(m => m.name), Is.EqualTo(CaseMethod.All.Select(m => m.Name)));
            Assert.That(data.cases.Single().panels.Select(p => p.error), Is.EqualTo(new[] { "height", "drift" }));
            Panel panel = data.cases[0].panels[0];
            Assert.That((panel.isFraction, panel.floor), Is.EqualTo((1, 0.04)));
            Assert.That(panel.points, Has.Length.EqualTo(5));
            Point wide = panel.points.Single(p => p.kappa == 2.5);
            Assert.That((wide.method, wide.factor, wide.seeds, wide.failures, wide.particles, wide.dx),
                Is.EqualTo((1, "Support", 3, 0, 1728, 0.083333)));
            Assert.That(wide.cost, Is.EqualTo(new[] { 100.0, 90, 110 }));
            Assert.That(wide.err, Is.EqualTo(new[] { 0.25, 0.24, 0.26 }));
            Point failed = panel.points.Single(p => p.failures > 0);
            Assert.That((failed.method, failed.factor, failed.reason, failed.err.Length, failed.front),
                Is.EqualTo((0, "Base", "energy grew", 0, 0)));
            Assert.That(panel.points.Where(p => p.front == 1).Select(p => p.method), Is.EqualTo(new[] { IndexOfStandard }),
                "cheaper and better than all others");
            Assert.That((panel.fits.Length, panel.marks.Length), Is.EqualTo((0, 0)));
        }

        [Test]
        public void CurvesOfModelsAndMarksAreDrawnBesideThePoints()
        {
            ChartReport report = Report("device", new FlatCase("one"));
            report.Cases[0].Panels[0].Fits.Add(new ReportFit("standard", "error as dx²", new[] { (10.0, 0.4), (100.0, 0.1) }));
            report.Cases[0].Panels[0].Marks
                .Add(new ReportMark("answer", SampleStatistics.Of(new[] { 40.0, 50, 60 }), SampleStatistics.Of(new[] { 0.1, 0.2, 0.4 })));
            Panel panel = DataOf(Html(report)).cases[0].panels[0];

            Assert.That((panel.fits.Single().method, panel.fits[0].title), Is.EqualTo((IndexOfStandard, "error as dx²")));
            Assert.That(panel.fits[0].cost.Zip(panel.fits[0].err, (c, e) => (c, e)), Is.EqualTo(new[] { (10.0, 0.4), (100.0, 0.1) }));
            Assert.That(panel.marks.Single().title, Is.EqualTo("answer"));
            Assert.That(panel.marks[0].cost, Is.EqualTo(new[] { 50.0, 40, 60 }));
            Assert.That(panel.marks[0].err, Is.EqualTo(new[] { 0.2, 0.1, 0.4 }));
        }

        [Test]
        public void NoTextOfTheTableIsTakenForHtml()
        {
            const string Bad = "</script><script>x()</script> & {{style}} \"'";
            string html = Html(Report("device", new[] { new FlatCase("one") }, Bad));

            Assert.That(html, Does.Not.Contain("<script>x()"));
            Assert.That(Parsed(html).SelectSingleNode("//section[@id='case-one']//details").InnerText, Does.Contain(Bad));
            Assert.That(DataOf(html).cases[0].panels[0].points.Single(p => p.failures > 0).reason, Is.EqualTo(Bad));
        }

        [Test]
        public void ThePageHasTheCurvesOfTheFolder()
        {
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", FlatCase.Result(1.0, 0.1).Series);
            Curves curves = DataOf(Html(Report("device", new FlatCase("one")))).cases[0].curves;

            Assert.That((curves.x, curves.y, curves.runs.Single().method, curves.runs[0].constants),
                Is.EqualTo(("t [s]", "h/H", 1, "dx 0.1 m")));
            Assert.That(curves.references.Single().name, Is.EqualTo("rest"));
            Assert.That(curves.references[0].bandX, Is.Empty);
            Assert.That(curves.runs[0].curves.Single().y, Has.Length.EqualTo(50));
            Assert.That(curves.runs[0].curves[0].y[1], Is.EqualTo(0.998));
        }

        [Test]
        public void TheFileIsWrittenWhereMeasurementsMayReplaceIt()
        {
            Assert.That(Report("device", new FlatCase("one")).Write(folder), Is.Null);

            string file = Path.Combine(folder, "report.html");
            Assert.That(File.ReadLines(file).First(), Is.EqualTo(ChartReport.File.FirstLine));
            Assert.That(() => ResultFolder.Open(folder, new[] { ChartReport.File }), Throws.Nothing);
        }

        [Test]
        public void APageWithAPlaceThatNothingFillsIsRefused()
        {
            var parts = new Dictionary<string, string> { ["title"] = "alone" };

            Assert.That(() => ReportPage.Load().Fill(parts), Throws.ArgumentException.With.Message.Contains("has a place for"));
            string[] places = { "firstLine", "title", "facts", "links", "costs", "cases", "bases", "equalTime", "data", "surplus" };
            Assert.That(() => ReportPage.Load().Fill(places.ToDictionary(p => p, p => "")),
                Throws.ArgumentException.With.Message.Contains("no place for 'surplus'"));
        }

        // The page darkens and lightens the chart's colours for its two backgrounds; a method's hue stays.
        [Test]
        public void APageHasTheHuesOfTheChart()
        {
            string page = Html(Report("device", new FlatCase("one")));
            MatchCollection colours = Regex.Matches(page, "--method-(\\d): (#[0-9a-f]{6});");
            Assert.That(colours.Count, Is.GreaterThanOrEqualTo(2 * CaseMethod.All.Count), "a colour a method in light and in dark");
            foreach (Match colour in colours)
            {
                float hue = Hue(colour.Groups[2].Value), chart = Hue(ChartStyle.Colour(int.Parse(colour.Groups[1].Value)).Split('\'')[1]);
                Assert.That(Mathf.Abs(Mathf.DeltaAngle(360f * hue, 360f * chart)), Is.LessThan(20f), colour.Value);
            }
        }

        private static float Hue(string colour)
        {
            int rgb = Convert.ToInt32(colour.Substring(1), 16);
            Color.RGBToHSV(new Color32((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb, 255), out float hue, out _, out _);
            return hue;
        }

        private ChartReport Report(string device, params ValidationCase[] cases) => Report(device, cases, "energy grew");

        private ChartReport Report(string device, ValidationCase[] cases, string reason)
        {
            var table = new ChartRows(device);
            foreach (ValidationCase validationCase in cases)
            {
                foreach (double kappa in new[] { 2.0, 2.5, 1.75 })
                    for (int seed = 1; seed <= 3; seed++)
                    {
                        Add(table, validationCase, "thesis", kappa, seed,
                            FlatCase.Result(100 + (seed - 2) * 10, 0.1 * kappa + 0.01 * (seed - 2)));
                    }
                Add(table, validationCase, "standard", 2.0, 1, FlatCase.Result(50, 0.05));
                Add(table, validationCase, "thesis-printed", 2.0, 1, FlatCase.Result(700, 0.0, reason));
            }
            List<ReportCase> reported = cases.Select(c => ChartPanel.Of(c, table.Rows))
                .Select(g => new ReportCase(g, EqualCost.Of(g[0].Points, g[0].Case.Floor), new CaseCurves(g[0].Case, folder))).ToList();
            return new ChartReport(reported, table.Rows, device, "chart --quick");
        }

        private static void Add(ChartRows table, ValidationCase validationCase, string method, double kappa, int seed, CaseResult result)
        {
            CaseParameters parameters = validationCase.Base(CaseMethod.Find(method));
            parameters.SupportRatio = kappa;
            table.Add(new ChartRun(new ChartConfig(validationCase, parameters, ChartFactor.Support), seed), result, "2026-11-21");
        }

        private static string Html(ChartReport report) => report.Html(ReportPage.Load());

        private static XmlDocument Parsed(string html)
        {
            var document = new XmlDocument { XmlResolver = null };
            using (XmlReader reader = XmlReader.Create(new StringReader(codeAndStyle.Replace(html, "$1$3")),
                new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore }))
                document.Load(reader);
            return document;
        }

        private static Data DataOf(string html) => JsonUtility.FromJson<Data>(dataIsland.Match(html).Groups[1].Value);

#pragma warning disable 0649 // JsonUtility fills them
        [Serializable]
        private sealed class Data
        {
            public Method[] methods;
            public Case[] cases;
        }

        [Serializable]
        private sealed class Method
        {
            public string name;
        }

        [Serializable]
        private sealed class Case
        {
            public Panel[] panels;
            public Curves curves;
        }

        [Serializable]
        private sealed class Panel
        {
            public string error;
            public int isFraction;
            public double floor;
            public Point[] points;
            public Fit[] fits;
            public Mark[] marks;
        }

        [Serializable]
        private sealed class Point
        {
            public int method, particles, seeds, failures, front;
            public string factor, reason;
            public double dx, kappa;
            public double[] cost, err;
        }

        [Serializable]
        private sealed class Fit
        {
            public int method;
            public string title;
            public double[] cost, err;
        }

        [Serializable]
        private sealed class Mark
        {
            public string title;
            public double[] cost, err;
        }

        [Serializable]
        private sealed class Curves
        {
            public string x, y;
            public Curve[] references;
            public Run[] runs;
        }

        [Serializable]
        private sealed class Run
        {
            public int method;
            public string constants;
            public Curve[] curves;
        }

        [Serializable]
        private sealed class Curve
        {
            public string name;
            public double[] x, y, bandX;
        }
#pragma warning restore 0649
    }
}
