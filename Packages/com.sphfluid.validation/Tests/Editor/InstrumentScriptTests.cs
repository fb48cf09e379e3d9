using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Columns and plot of what instruments read.</summary>
    public sealed class InstrumentScriptTests
    {
        private static InstrumentCurve Curve(string name, string column, string unit, int firstRow, params double[] values)
        {
            var curve = new InstrumentCurve($"{name}.{column}", name, new FluidReading(column, unit, 0.0), firstRow);
            for (int i = 0; i < values.Length; i++) curve.Add(firstRow + i, 0.1 * (firstRow + i), values[i]);
            return curve;
        }

        [Test]
        public void ARowWithoutAReadingHasNone()
        {
            InstrumentCurve curve = Curve("Wall", "pressure_pa", "Pa", 2, 5.0, 6.0);
            curve.Add(6, 0.6, 7.0); // rows 4 and 5 were of another liquid
            Assert.That(Enumerable.Range(0, 8).Select(curve.At),
                Is.EqualTo(new[] { double.NaN, double.NaN, 5.0, 6.0, double.NaN, double.NaN, 7.0, double.NaN }));
        }

        [Test]
        public void AQuantityIsAPanelAndAnInstrumentALine()
        {
            var script = new InstrumentScript("waves-instruments", new[]
            {
                Curve("Wall", "pressure_pa", "Pa", 0, double.NaN, 100.0), Curve("Gauge's", "height_m", "m", 0, 0.2, 0.3),
                Curve("Floor", "pressure_pa", "Pa", 0, 1.0, 2.0), Curve("Dry", "height_m", "m", 0, double.NaN),
            });
            string[] lines = script.Lines().ToArray();
            Assert.That(script.FileName, Is.EqualTo("waves-instruments.gp"));
            Assert.That(lines, Has.Exactly(1).EqualTo("set ylabel 'pressure [Pa]'").And.Exactly(1).EqualTo("set ylabel 'height [m]'"));
            Assert.That(lines, Has.Exactly(1).StartsWith("set multiplot layout 2,1"));
            Assert.That(lines.Count(l => l.StartsWith("plot ")), Is.EqualTo(2));
            Assert.That(string.Join("\n", lines), Does.Contain("title 'Floor'").And.Contain("title 'Gauge''s'"));
            int block = System.Array.IndexOf(lines, "$curve0 << END");
            Assert.That(lines.Skip(block + 1).TakeWhile(l => l != "END"), Is.EqualTo(new[] { "0.1 100" }), "what is no number is left out");
        }

        [Test]
        public void WithoutReadingsThereIsNoPlot()
        {
            Assert.That(new InstrumentScript("a", new InstrumentCurve[0]).IsEmpty);
            Assert.That(new InstrumentScript("a", new[] { Curve("Dry", "height_m", "m", 0, double.NaN) }).IsEmpty);
        }

        [Test]
        public void WithoutInstrumentsTheRecordStaysAsItIs()
        {
            string file = Path.GetTempFileName();
            try
            {
                File.WriteAllText(file, "frame,time_s\n0,0.1\n");
                new InstrumentRecord().AppendTo(file);
                Assert.That(File.ReadAllText(file), Is.EqualTo("frame,time_s\n0,0.1\n"));
            }
            finally
            {
                File.Delete(file);
            }
        }
    }
}
