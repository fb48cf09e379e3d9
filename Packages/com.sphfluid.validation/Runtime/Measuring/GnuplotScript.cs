using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A gnuplot script, with its data, that draws one picture in one or more formats in its folder.</summary>
    public abstract class GnuplotScript
    {
        private readonly string stem;
        private readonly string[] formats;

        /// <param name="stem">Name of the script and its pictures without ending.</param>
        /// <param name="formats">Endings of the pictures.</param>
        private protected GnuplotScript(string stem, params string[] formats)
        {
            this.stem = stem;
            this.formats = formats;
        }

        /// <summary>Name of the script's file.</summary>
        public string FileName => FileOf(stem);

        /// <summary>The script's lines.</summary>
        public IEnumerable<string> Lines() => new[] { FirstLine(stem, formats) }.Concat(Body());

        /// <summary>Script and pictures, for <see cref="ResultFolder"/>.</summary>
        internal static IEnumerable<ResultFile> Files(string stem, params string[] formats) =>
            formats.Select(f => ResultFile.Drawn($"{stem}.{f}", FileOf(stem)))
                .Prepend(ResultFile.Text(FileOf(stem), FirstLine(stem, formats)));

        /// <summary>Writes scripts and draws them, up to the first that cannot be drawn.</summary>
        /// <param name="folder">Folder of scripts and pictures.</param>
        /// <param name="scripts">The scripts.</param>
        /// <returns>Null, or a line that says what is wrong and how to draw it later.</returns>
        internal static string Draw(string folder, IEnumerable<GnuplotScript> scripts)
        {
            string problem = null;
            foreach (GnuplotScript script in scripts)
            {
                string file = Path.Combine(folder, script.FileName);
                CsvText.WriteWhole(file, script.Lines());
                problem = problem ?? Gnuplot.Draw(file);
            }
            return problem;
        }

        /// <summary>The lines after the first one.</summary>
        private protected abstract IEnumerable<string> Body();

        /// <summary>Draws the same in SVG and PNG; fonts of PNG are smaller because its points are larger.</summary>
        /// <param name="size">Width and height in pixels, divided by a comma.</param>
        /// <param name="svgFont">Size of the font in SVG.</param>
        /// <param name="pngFont">Size of the font in PNG.</param>
        /// <param name="drawing">The commands.</param>
        private protected IEnumerable<string> InSvgAndPng(string size, int svgFont, int pngFont, IEnumerable<string> drawing)
        {
            yield return "do for [format in \"svg png\"] {";
            yield return "reset";
            yield return $"if (format eq \"svg\") {{ set terminal svg noenhanced size {size} font 'DejaVu Sans,{svgFont}' background " +
                $"'white' }} " +
                $"else {{ set terminal pngcairo noenhanced size {size} font 'DejaVu Sans,{pngFont}' background 'white' }}";
            yield return $"set output '{stem}.' . format";
            foreach (string line in drawing) yield return line;
            yield return "unset output";
            yield return "}";
        }

        /// <summary>A block of data.</summary>
        private protected static IEnumerable<string> Block(string name, IEnumerable<string> lines) =>
            new[] { name + " << END" }.Concat(lines).Append("END");

        /// <summary>A plot of layers, a line each.</summary>
        private protected static string Plot(IEnumerable<string> layers) => "plot " + string.Join(", \\\n    ", layers);

        private static string FileOf(string stem) => stem + ".gp";

        private static string FirstLine(string stem, string[] formats) =>
            $"# Draws {string.Join(" and ", formats.Select(f => $"{stem}.{f}"))}: gnuplot {FileOf(stem)}";
    }
}
