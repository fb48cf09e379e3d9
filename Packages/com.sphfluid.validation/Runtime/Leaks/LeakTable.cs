using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace SphFluid.Validation
{
    /// <summary>leaks.csv: a line for each run of a scene.</summary>
    sealed class LeakTable
    {
        public const string FileName = "leaks.csv";

        public static readonly string[] Columns =
        {
            "scene", "speed_m_s", "particles", "triangles", "frames", "steps", "escapes", "failure", "contacts", "fallbacks", "squeezed", "overlaps",
            "shortened", "jumps", "non_finite", "max_speed_m_s", "energy_ratio", "first_layer_dx", "pressed_share", "held_share", "drag", "device", "date",
        };

        readonly List<string> lines = new List<string> { CsvText.Join(Columns) };
        readonly string folder, device, date;

        public LeakTable(string folder, string device)
        {
            this.folder = folder;
            this.device = device;
            date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
        }

        /// <summary>Adds a line and writes the file.</summary>
        public void Add(LeakResult result)
        {
            lines.Add(LineOf(result));
            CsvText.WriteWhole(Path.Combine(folder, FileName), lines);
        }

        string LineOf(LeakResult result)
        {
            LeakScene scene = result.Scene;
            FluidCounters counted = result.Counters;
            return CsvText.Join(new[]
            {
                scene.Name, CsvText.Text(scene.Speed), CsvText.Text(scene.Particles.Length), CsvText.Text(scene.Surface.Length / 3),
                CsvText.Text(scene.Frames), CsvText.Text(result.Steps), CsvText.Text(result.Escapes), result.Failure, CsvText.Text(counted.Contacts),
                CsvText.Text(counted.ContactFallbacks), CsvText.Text(counted.Squeezed), CsvText.Text(counted.Overlaps),
                CsvText.Text(counted.ShortenedSteps), CsvText.Text(result.Jumps), CsvText.Text(counted.NonFinite), CsvText.Text(result.MaxSpeed),
                CsvText.Text(result.EnergyRatio), CsvText.Text(result.Rest?.FirstLayer ?? double.NaN), CsvText.Text(result.Rest?.Pressed ?? double.NaN),
                CsvText.Text(result.Rest?.Held ?? double.NaN), CsvText.Text(result.Drag), device, date,
            });
        }
    }
}
