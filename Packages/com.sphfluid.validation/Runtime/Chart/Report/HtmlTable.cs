using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>A table of the report. The first cell of a row is its heading; columns of numbers are aligned right.</summary>
    internal sealed class HtmlTable
    {
        private readonly string caption;
        private readonly IReadOnlyList<(string Title, bool IsNumber)> columns;
        private readonly List<IReadOnlyList<string>> rows = new List<IReadOnlyList<string>>();

        /// <param name="caption">What it shows.</param>
        /// <param name="columns">Titles, and whether a column has numbers.</param>
        public HtmlTable(string caption, params (string Title, bool IsNumber)[] columns)
        {
            this.caption = caption;
            this.columns = columns;
        }

        /// <summary>Whether it has no row.</summary>
        public bool IsEmpty => rows.Count == 0;

        /// <summary>Adds a row of texts.</summary>
        public void Add(IEnumerable<string> cells) => rows.Add(cells.ToList());

        /// <summary>The element; it scrolls on narrow screens.</summary>
        public override string ToString()
        {
            var html = new StringBuilder("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"")
                .Append(ReportWords.Html(caption)).Append("\"><table>\n<caption>")
                .Append(ReportWords.Html(caption)).Append("</caption>\n<thead><tr>");
            foreach ((string title, bool isNumber) in columns)
            {
                html.Append("<th scope=\"col\"").Append(isNumber ? " class=\"number\">" : ">").Append(ReportWords.Html(title))
                    .Append("</th>");
            }
            html.Append("</tr></thead>\n<tbody>\n");
            foreach (IReadOnlyList<string> row in rows)
            {
                html.Append("<tr>");
                for (int i = 0; i < row.Count; i++)
                {
                    html.Append(i == 0 ? "<th scope=\"row\">" : columns[i].IsNumber ? "<td class=\"number\">" : "<td>")
                        .Append(ReportWords.Html(row[i])).Append(i == 0 ? "</th>" : "</td>");
                }
                html.Append("</tr>\n");
            }
            return html.Append("</tbody></table></div>").ToString();
        }
    }
}
