using System;
using System.Globalization;
using System.Net;

namespace SphFluid.Validation
{
    /// <summary>Numbers and texts as the report writes them.</summary>
    internal static class ReportWords
    {
        /// <summary>Frames of a second of a game.</summary>
        public const double FramesPerSecond = 60.0;

        /// <summary>A text between tags or in quotes of an attribute.</summary>
        public static string Html(string text) => WebUtility.HtmlEncode(text);

        /// <summary>An error: as per cent, or as a number where it has a unit.</summary>
        public static string Error(double value, bool isFraction) => isFraction ? Digits(100.0 * value) + " %" : Digits(value);

        /// <summary>Milliseconds of GPU time.</summary>
        public static string Milliseconds(double value) => Digits(value);

        /// <summary>Milliseconds of a frame at 60 Hz of a number of milliseconds per simulated second: 240 is 4.</summary>
        public static string PerFrame(double perSecond) => Digits(perSecond / FramesPerSecond);

        /// <summary>Two digits, all before the point, and thousands divided: 0.0123 is 0.012, 12345 is 12,345.</summary>
        public static string Digits(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value)) return "–";
            double size = Math.Abs(value);
            if (size >= 9.95) return Math.Round(value).ToString("#,0", CultureInfo.InvariantCulture);
            string text = value.ToString("G2", CultureInfo.InvariantCulture);
            return text.Contains("E") ? double.Parse(text, CultureInfo.InvariantCulture)
                .ToString("0.############", CultureInfo.InvariantCulture) : text;
        }

        /// <summary>A constant with three digits.</summary>
        public static string Constant(double value) => value.ToString("G3", CultureInfo.InvariantCulture);
    }
}
