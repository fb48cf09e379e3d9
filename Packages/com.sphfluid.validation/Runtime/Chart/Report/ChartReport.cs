using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>
    /// The chart as one HTML file that needs no other: panels whose points say what they are, the cases' curves, sentences and tables.
    /// Models' curves and marks that are added to its panels before it is written are drawn with them.
    /// </summary>
    internal sealed class ChartReport
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "report.html";

        private const string FirstLine = "<!DOCTYPE html><!-- SPH Fluid, accuracy chart -->";

        private readonly string device, command;
        private readonly IReadOnlyList<ChartRow> rows;

        /// <param name="cases">The cases in the order of the page.</param>
        /// <param name="rows">The table: for device, dates and the number of runs.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="command">The command that measured last, for instance "chart --quick".</param>
        public ChartReport(IReadOnlyList<ReportCase> cases, IReadOnlyList<ChartRow> rows, string device, string command)
        {
            Cases = cases;
            this.rows = rows;
            this.device = device;
            this.command = command;
        }

        /// <summary>The cases in the order of the page.</summary>
        public IReadOnlyList<ReportCase> Cases { get; }

        /// <summary>The file, for <see cref="ResultFolder"/>.</summary>
        internal static ResultFile File => ResultFile.Text(FileName, FirstLine);

        /// <summary>Writes the file.</summary>
        /// <param name="folder">The chart's folder.</param>
        /// <returns>Null, or a line that says why there is none.</returns>
        public string Write(string folder)
        {
            ReportPage page = ReportPage.Load();
            if (page == null)
            {
                return $"No {FileName}: its page is an asset of com.sphfluid.validation that only the Editor can read. Draw the chart " +
                    "there: accuracy.csv holds all that it needs.";
            }
            CsvText.WriteWhole(Path.Combine(folder, FileName), new[] { Html(page) });
            return null;
        }

        internal string Html(ReportPage page) => page.Fill(new Dictionary<string, string>
        {
            ["firstLine"] = FirstLine,
            ["title"] = ReportWords.Html($"Error against GPU time: {device}"),
            ["facts"] = Facts(),
            ["links"] = string.Concat(Cases.Select(c => $"<li><a href=\"#{Anchor(c)}\">{ReportWords.Html(c.Case.Title)}</a></li>")),
            ["costs"] = ReportTables.Costs(Cases).ToString(),
            ["cases"] = string.Concat(Cases.Select(Section)),
            ["bases"] = ReportTables.Bases(Cases).ToString(),
            ["equalTime"] = EqualTime(),
            ["data"] = ReportJson.Of(Cases),
        });

        private string EqualTime()
        {
            HtmlTable table = ReportTables.AtEqualTime(Cases);
            return table.IsEmpty ? "<p>One method was measured, or none at times that another has.</p>" : table.ToString();
        }

        private string Facts()
        {
            string first = rows.Min(r => r.Date), last = rows.Max(r => r.Date);
            int runs = rows.Select(r => r.Key).Distinct().Count(), failed = rows.Where(r => r.Failed).Select(r => r.Key).Distinct().Count();
            var facts = new (string Name, string Value)[]
            {
                ("Device", device),
                ("Measured", first == last ? first : $"{first} to {last}"),
                ("Runs", failed == 0 ? ReportWords.Digits(runs)
                    : $"{ReportWords.Digits(runs)}, of which {ReportWords.Digits(failed)} failed"),
                ("Command", command),
            };
            return string.Concat(facts.Select(f => $"<div><dt>{f.Name}</dt><dd>{ReportWords.Html(f.Value)}</dd></div>"));
        }

        private string Section(ReportCase reported, int index)
        {
            var html = new StringBuilder();
            html.Append(
                $"<section class=\"case\" id=\"{Anchor(reported)}\" " +
                $"data-case=\"{index}\">\n<h2>{ReportWords.Html(reported.Case.Title)}</h2>\n<ul class=\"summary\">\n");
            foreach (string sentence in ReportSummary.Of(reported)) html.Append($"<li>{ReportWords.Html(sentence)}</li>\n");
            html.Append("</ul>\n<div class=\"figures\"></div>\n");
            if (reported.Case.Caution.Length > 0) html.Append($"<p class=\"caution\">{ReportWords.Html(reported.Case.Caution)}</p>\n");
            html.Append($"<details>\n<summary>All points as a table</summary>\n{ReportTables.Points(reported)}\n</details>\n");
            html.Append($"<p class=\"source\">Reference: {ReportWords.Html(reported.Case.Source)}</p>\n</section>\n");
            return html.ToString();
        }

        private static string Anchor(ReportCase reported) => "case-" + reported.Case.Name;
    }
}
