using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Writes a script for each map of the tables, and by gnuplot its pictures.</summary>
    sealed class StabilityDrawing
    {
        readonly string folder;
        readonly StabilityFiles files;
        readonly SessionProgress progress;

        public StabilityDrawing(string folder, StabilityFiles files, SessionProgress progress)
        {
            this.folder = folder;
            this.files = files;
            this.progress = progress;
        }

        public void Write()
        {
            string trouble = null;
            foreach (StabilityMap map in StabilityMaps.All)
            {
                foreach (bool clamps in new[] { false, true })
                {
                    List<StabilityRow> rows = files.Rows.Where(r => r.Map == map.Name && r.Clamps == clamps).ToList();
                    if (rows.Count == 0)
                        continue;
                    var script = new StabilityScript(map, rows, clamps, files.Device);
                    CsvText.WriteWhole(Path.Combine(folder, script.FileName), script.Lines());
                    trouble = trouble ?? Gnuplot.Draw(Path.Combine(folder, script.FileName));
                }
            }
            progress.Say(trouble ?? $"{StabilityRow.FileName}, {LimitRow.FileName} and a picture a map, stability-m1.png and so on, are in '{folder}'.");
        }
    }
}
