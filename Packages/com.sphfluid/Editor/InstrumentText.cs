using System;
using System.Globalization;

namespace SphFluid.Editor
{
    /// <summary>Readings of instruments as people read them.</summary>
    internal static class InstrumentText
    {
        /// <summary>A number of four digits with its unit; a dash where there is none.</summary>
        public static string Describe(FluidReading reading) => double.IsNaN(reading.Value) ? "–"
            : string.Format(CultureInfo.InvariantCulture, "{0} {1}", Round(reading.Value), reading.Unit);

        /// <summary>The name without its unit: peak_pressure of peak_pressure_pa.</summary>
        public static string NameOf(FluidReading reading)
        {
            string unit = "_" + reading.Unit.Replace("²", "2").Replace("³", "3").Replace("/", "_").ToLowerInvariant();
            return reading.Column.EndsWith(unit, StringComparison.Ordinal)
                ? reading.Column.Substring(0, reading.Column.Length - unit.Length) : reading.Column;
        }

        private static string Round(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(size >= 1000.0 ? "0" : size >= 100.0 ? "0.0" : size >= 10.0 ? "0.00" : size >= 0.1 ||
                size == 0.0 ? "0.000" : "0.000e+0", CultureInfo.InvariantCulture);
        }
    }
}
