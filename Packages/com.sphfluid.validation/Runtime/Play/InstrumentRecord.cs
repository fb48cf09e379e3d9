using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What the instruments of a scene read in each frame: columns of the record, and curves.</summary>
    internal sealed class InstrumentRecord
    {
        private readonly List<FluidInstrument> order = new List<FluidInstrument>();
        private readonly Dictionary<FluidInstrument, string> names = new Dictionary<FluidInstrument, string>();
        private readonly Dictionary<string, InstrumentCurve> curves = new Dictionary<string, InstrumentCurve>();
        private readonly List<InstrumentCurve> inOrder = new List<InstrumentCurve>();
        private int rows;

        /// <summary>The curves, in the order of their first reading; values of rows without one are not numbers.</summary>
        public IReadOnlyList<InstrumentCurve> Curves => inOrder;

        /// <summary>Adds the readings of a liquid's instruments as a row, waiting for the GPU.</summary>
        /// <param name="simulation">The liquid.</param>
        public void AddRow(FluidSimulation simulation)
        {
            foreach (FluidInstrument instrument in FluidInstrument.Active.ToArray())
            {
                if (instrument.Liquid != simulation) continue;
                instrument.ReadNow();
                string name = NameOf(instrument);
                foreach (FluidReading reading in instrument.Readings)
                {
                    string column = $"{name}.{reading.Column}";
                    if (!curves.TryGetValue(column, out InstrumentCurve curve))
                    {
                        curves.Add(column, curve = new InstrumentCurve(column, name, reading, rows));
                        inOrder.Add(curve);
                    }
                    curve.Add(rows, instrument.HasValue ? instrument.ReadTime : double.NaN, reading.Value);
                }
            }
            rows++;
        }

        /// <summary>Puts the readings into the record's table behind its last column; empty where an instrument did not read.</summary>
        /// <param name="file">The record, a row for each that was added here.</param>
        public void AppendTo(string file)
        {
            if (inOrder.Count == 0) return;
            string[] lines = File.ReadAllLines(file);
            lines[0] += "," + string.Join(",", inOrder.Select(c => c.Column));
            for (int i = 1; i < lines.Length; i++) lines[i] += "," + string.Join(",", inOrder.Select(c => Cell(c.At(i - 1))));
            CsvText.WriteWhole(file, lines);
        }

        private static string Cell(double value) => double.IsNaN(value) ? "" : value.ToString("R", CultureInfo.InvariantCulture);

        // Names of objects may be equal, and hold what a table cannot.
        private string NameOf(FluidInstrument instrument)
        {
            if (names.TryGetValue(instrument, out string name)) return name;
            string plain =
                new string(instrument.name.Select(c => c == ',' || c == '"' || c == '\'' || char.IsControl(c) ? '_' : c).ToArray()).Trim();
            name = plain;
            for (int number = 2; names.ContainsValue(name); number++) name = $"{plain} {number}";
            names.Add(instrument, name);
            return name;
        }
    }

    /// <summary>What one instrument read of one quantity.</summary>
    internal sealed class InstrumentCurve
    {
        private readonly int firstRow;
        private readonly List<(double Time, double Value)> points = new List<(double Time, double Value)>();

        public InstrumentCurve(string column, string instrument, FluidReading reading, int firstRow)
        {
            Column = column;
            Instrument = instrument;
            Unit = reading.Unit;
            Quantity = reading.Column;
            this.firstRow = firstRow;
        }

        /// <summary>Name in the record.</summary>
        public string Column { get; }

        /// <summary>Name of the instrument.</summary>
        public string Instrument { get; }

        /// <summary>Name of the quantity with its unit.</summary>
        public string Quantity { get; }

        /// <summary>Unit as people write it.</summary>
        public string Unit { get; }

        /// <summary>Times and values of the readings; not numbers where there is none.</summary>
        public IReadOnlyList<(double Time, double Value)> Points => points;

        /// <summary>Takes a row; rows between the last and this had no reading.</summary>
        public void Add(int row, double time, double value)
        {
            while (points.Count < row - firstRow) points.Add((double.NaN, double.NaN));
            points.Add((time, value));
        }

        /// <summary>The value of a row; not a number where there is none.</summary>
        public double At(int row) => row >= firstRow && row - firstRow < points.Count ? points[row - firstRow].Value : double.NaN;
    }
}
