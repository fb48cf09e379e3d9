using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class ChartScriptTests
    {
        private string folder;

        [SetUp]
        public void SetUp()
        {
            folder = TestFolder.Fresh();
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void TearDown() => TestFolder.Delete(folder);

        [Test]
        public void HasAPanelACaseAndWhatTheReaderNeeds()
        {
            string script = Script(new FlatCase("one"), new FlatCase("two"));

            Assert.That(Count(script, "set title 'A cube''s rest'"), Is.EqualTo(2));
            Assert.That(script, Does.Contain("title 'Error against GPU time. A ''fast'' one, 2026-11-21'"));
            Assert.That(script, Does.Contain("set logscale xy"));
            Assert.That(script, Does.Contain("format eq \"svg\"").And.Contain("pngcairo"));
            Assert.That(script, Does.Contain("'4 ms/frame' at 240").And.Contain("'8 ms/frame' at 480"));
            Assert.That(script, Does.Contain("first 0.04 fc rgb").And.Contain("reference floor 4 %"));
            Assert.That(script, Does.Contain("title 'thesis, corrected'").And.Contain("title 'thesis, as printed'"));
            Assert.That(script, Does.Contain("xyerrorbars"));
        }

        [Test]
        public void ASweepRunsThroughTheBase()
        {
            string[] lines = Script(new FlatCase("one")).Split('\n');
            int start = Array.FindIndex(lines, l => l.StartsWith("$p0_1_Support << END", StringComparison.Ordinal));

            // κ 1.75 and 2.5 with the base's 2 between them; the last columns mark the sweep's own points and its ends.
            Assert.That(lines.Skip(start + 1).Take(4), Is.EqualTo(new[]
            {
                "100 0.175 90 110 0.165 0.185 1 \"1.75\"", "100 0.2 90 110 0.19 0.21 0 \"\"", "100 0.25 90 110 0.24 0.26 1 \"2.5\"", "END",
            }));
        }

        [Test]
        public void FailedRunsAreOpenMarksAtTheTop()
        {
            string[] lines = Script(new FlatCase("one")).Split('\n');

            int start = Array.FindIndex(lines, l => l.StartsWith("$p0_0_Base_failed << END", StringComparison.Ordinal));
            Assert.That(lines.Skip(start + 1).Take(2), Is.EqualTo(new[] { "700", "END" }));
            string plot = lines.Single(l => l.Contains("$p0_0_Base_failed using"));
            Assert.That(plot, Does.Contain("pt 6"));
            double top = double.Parse(plot.Split(new[] { "1:(" }, StringSplitOptions.None)[1].Split(')')[0],
                System.Globalization.CultureInfo.InvariantCulture);
            Assert.That(top, Is.GreaterThan(0.3), "above every error");
        }

        [Test]
        public void CompanionErrorStandsBesideTheMainOneWithTheCaution()
        {
            string script = Script(new FlatCase("zero"),
                new FlatCase("one") { Companion = "drift", Warning = "The gate's delay: " + new string('x', 170) });

            Assert.That(script, Does.Contain("set ylabel 'height'").And.Contain("set ylabel 'drift'"));
            Assert.That(script, Does.Contain("'The gate''s delay:'"), "wrapped");
            Assert.That(script, Does.Contain("set bmargin 6"));
            string[] ranges = script.Split('\n').Where(l => l.StartsWith("set yrange", StringComparison.Ordinal)).ToArray();
            Assert.That(ranges, Has.Length.EqualTo(3));
            Assert.That(ranges[1], Is.EqualTo(ranges[2]), "equal ranges compare");
            Assert.That(ranges[0], Is.Not.EqualTo(ranges[1]));
        }

        [Test]
        public void APanelThatNoRunHasTheErrorOfIsEmptyAndTheOthersAreDrawn()
        {
            var table = new ChartRows("device");
            var renamed = new FlatCase("one") { MainError = "depth" };
            table.Add(new ChartRun(new ChartConfig(renamed, renamed.Base(CaseMethod.Find("thesis")), ChartFactor.Base), 1),
                FlatCase.Result(100, 0.1), "2026-11-21");
            var known = new FlatCase("two");
            table.Add(new ChartRun(new ChartConfig(known, known.Base(CaseMethod.Find("thesis")), ChartFactor.Base), 1),
                FlatCase.Result(100, 0.1), "2026-11-21");
            string script = string.Join("\n",
                new ChartScript(new[] { ChartPanel.Of(renamed, table.Rows), ChartPanel.Of(known, table.Rows) }, "device",
                    "2026-11-21").Lines());

            Assert.That(script, Does.Contain("set ylabel 'depth'\n").And.Contain("\nplot 1/0\n").And.Contain("\nplot $p1_1_Base using"));
            if (Gnuplot.Draw(Write("empty.gp", "")) == null) Assert.That(Gnuplot.Draw(Write("accuracy.gp", script)), Is.Null);
        }

        [Test]
        public void ACasesPictureHasItsCurvesAndTheReference()
        {
            var flat = new FlatCase("one");
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", FlatCase.Result(1.0, 0.1).Series);
            string script = string.Join("\n", new CurveScript(flat, folder).Lines());

            Assert.That(script, Does.Contain("set output 'case-one.png'"));
            Assert.That(script, Does.Contain("title 'rest'").And.Contain("title 'thesis, corrected: height'"));
            Assert.That(script, Does.Contain("set ylabel 'h/H'").And.Contain("'A cube''s rest'.\"\\n\".'dx 0.1 m'"));
            Assert.That(script, Does.Contain("\n0.02 0.998\n"));
            Assert.That(new CurveScript(new FlatCase("two"), folder).IsEmpty, Is.True);
        }

        [Test]
        public void APictureTakesTheLongestReferenceAndALineForEachMethodsConstants()
        {
            IReadOnlyList<CaseSeries> whole = FlatCase.Result(1.0, 0.1).Series;
            var early = new CaseSeries("rest", true);
            early.Add(0.0, 1.0);
            early.Add(0.1, 1.0);
            CurveFile.Write(folder, "one", "thesis-printed", "dx 0.2 m", new[] { whole[0], early }); // the first of the methods
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", whole);
            CurveFile.Write(folder, "one", "standard", "dx 0.1 m", new[] { whole[0], early });
            var curves = new CaseCurves(new FlatCase("one"), folder);
            string script = string.Join("\n", new CurveScript(new FlatCase("one"), folder).Lines());

            Assert.That(curves.References.Single().X.Last(), Is.EqualTo(0.98));
            Assert.That(curves.Runs.Select(r => r.Constants), Is.EqualTo(new[] { "dx 0.2 m", "dx 0.1 m", "dx 0.1 m" }));
            Assert.That(script,
                Does.Contain(".\"\\n\".'thesis, as printed: dx 0.2 m'.\"\\n\".'thesis, corrected: dx 0.1 m'.\"\\n\".'standard: dx 0.1 m'"));
        }

        [Test]
        public void ManyReferencesHaveAPanelEach()
        {
            List<CaseSeries> curves = Enumerable.Range(0, 3)
                .SelectMany(i => FlatCase.Result(1.0, 0.1).Series.Select(c => Renamed(c, c.Name + " " + i))).ToList();
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", curves);
            string script = string.Join("\n", new CurveScript(new FlatCase("one"), folder).Lines());

            Assert.That(script, Does.Contain("set multiplot layout 2,2"));
            Assert.That(Count(script, "\nplot "), Is.EqualTo(3));
            Assert.That(script, Does.Contain("set title 'rest 2'"));
        }

        [Test]
        public void ABandIsReadBackAndDrawnBehindItsReference()
        {
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", WithBand());
            var curves = new CaseCurves(new FlatCase("one"), folder);
            string script = string.Join("\n", new CurveScript(new FlatCase("one"), folder).Lines());

            CaseSeries band = curves.BandOf(curves.References.Single());
            Assert.That(band.X, Is.EqualTo(new[] { 0.1, 0.5 }));
            Assert.That(band.Y, Is.EqualTo(new[] { 0.9, 0.8 }));
            Assert.That(band.Upper, Is.EqualTo(new[] { 1.1, 3.0 }));
            Assert.That(script, Does.Contain("0.5 0.8 3").And.Contain("with filledcurves"));
            Assert.That(script.IndexOf("$band0 using"), Is.LessThan(script.IndexOf("$reference0 using")), "behind");
            Assert.That(script, Does.Match("set yrange .*:3"), "all of it is seen");
        }

        [Test]
        public void GnuplotDrawsTheScripts()
        {
            if (Gnuplot.Draw(Write("empty.gp", "")) != null) Assert.Ignore("gnuplot is not installed.");
            CurveFile.Write(folder, "one", "thesis", "dx 0.1 m", WithBand());
            ValidationCase[] cases = { new FlatCase("one") { Companion = "drift", Warning = "A caution." }, new FlatCase("two") };

            Assert.That(Gnuplot.Draw(Write("accuracy.gp", Script(cases))), Is.Null);
            Assert.That(Gnuplot.Draw(Write("case-one.gp", string.Join("\n", new CurveScript(cases[0], folder).Lines()))), Is.Null);

            foreach (string file in new[] { "accuracy.png", "case-one.png" })
            {
                Assert.That(File.ReadAllBytes(Path.Combine(folder, file)).Take(4),
                    Is.EqualTo(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G' }), file);
            }
            Assert.That(File.ReadAllText(Path.Combine(folder, "accuracy.svg")), Does.Contain("</svg>").And.Contain("reference floor"));
        }

        private static List<CaseSeries> WithBand()
        {
            var band = new CaseSeries("rest", true);
            band.AddBand(0.1, 0.9, 1.1);
            band.AddBand(0.5, 0.8, 3.0);
            return FlatCase.Result(1.0, 0.1).Series.Append(band).ToList();
        }

        [Test]
        public void AMissingGnuplotIsOneLine()
        {
            string script = Write("accuracy.gp", "plot x");
            string message = Gnuplot.Draw(script, "no-such-gnuplot");

            Assert.That(message, Does.Contain("apt-get install gnuplot-nox").And.Contain("gnuplot accuracy.gp").And.Not.Contain("\n"));
            Assert.That(File.Exists(script), Is.True);
        }

        [Test]
        public void ABrokenScriptIsReported()
        {
            if (Gnuplot.Draw(Write("empty.gp", "")) != null) Assert.Ignore("gnuplot is not installed.");
            Assert.That(Gnuplot.Draw(Write("broken.gp", "plott x")), Does.Contain("broken.gp").And.Contain("invalid command"));
        }

        [TestCase(0.0011, 0.9, new[] { 0.001, 0.01, 0.1, 1.0 })]
        [TestCase(0.1, 0.2, new[] { 0.1, 0.2 })]
        [TestCase(0.11, 0.7, new[] { 0.1, 0.2, 0.3, 0.5 })]
        [TestCase(0.03, 0.7, new[] { 0.05, 0.1, 0.2, 0.5 })]
        public void AxesHaveTheirOwnTics(double low, double high, double[] tics)
        {
            ChartAxis axis = ChartAxis.Of(new[] { low, high });

            Assert.That(axis.Low, Is.LessThan(low));
            Assert.That(axis.High, Is.GreaterThan(high));
            Assert.That(axis.Tics(), Is.EqualTo(tics));
        }

        [TestCase(0.02, "2 %", "0.02")]
        [TestCase(0.001, "0.1 %", "0.001")]
        [TestCase(10, "1k %", "10")]
        [TestCase(20000, "2M %", "20k")]
        [TestCase(500, "50k %", "500")]
        [TestCase(2e6, "200M %", "2M")]
        public void LabelsAreShort(double value, string percent, string plain)
        {
            Assert.That(ChartAxis.Percent(value), Is.EqualTo(percent));
            Assert.That(ChartAxis.Short(value), Is.EqualTo(plain));
        }

        // Base and two κ of the corrected method, and a base of the printed one that fails. Errors are κ/10, 0.01 apart.
        private static string Script(params ValidationCase[] cases)
        {
            var table = new ChartRows("A 'fast' one");
            foreach (ValidationCase validationCase in cases)
            {
                foreach (double kappa in new[] { 2.0, 2.5, 1.75 })
                {
                    CaseParameters parameters = validationCase.Base(CaseMethod.Find("thesis"));
                    parameters.SupportRatio = kappa;
                    for (int seed = 1; seed <= 3; seed++)
                    {
                        table.Add(new ChartRun(new ChartConfig(validationCase, parameters, ChartFactor.Support), seed),
                            FlatCase.Result(100 + (seed - 2) * 10, 0.1 * kappa + 0.01 * (seed - 2)), "2026-11-21");
                    }
                }
                table
                    .Add(
                        new ChartRun(new ChartConfig(validationCase, validationCase.Base(CaseMethod.Find("thesis-printed")),
                            ChartFactor.Base), 1),
                    FlatCase.Result(700, 0.0, "energy grew"), "2026-11-21");
            }
            List<IReadOnlyList<ChartPanel>> groups = cases.Select(c => ChartPanel.Of(c, table.Rows)).ToList();
            return string.Join("\n", new ChartScript(groups, table.Device, "2026-11-21").Lines());
        }

        private static CaseSeries Renamed(CaseSeries curve, string name)
        {
            var renamed = new CaseSeries(name, curve.IsReference);
            for (int i = 0; i < curve.X.Count; i++) renamed.Add(curve.X[i], curve.Y[i]);
            return renamed;
        }

        private string Write(string name, string text)
        {
            string file = Path.Combine(folder, name);
            File.WriteAllText(file, text);
            return file;
        }

        private static int Count(string text, string part) => text.Split(new[] { part }, StringSplitOptions.None).Length - 1;
    }
}
