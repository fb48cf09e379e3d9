using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace SphFluid.Tests
{
    /// <summary>Headings of a page of a manual.</summary>
    internal static class ManualHeadings
    {
        /// <summary>The headings of a page, as links have them.</summary>
        public static IEnumerable<string> Of(string page) =>
            File.ReadAllText(Path.GetFullPath(page)).Split('\n').Where(l => l.StartsWith("#", StringComparison.Ordinal))
            .Select(l => Link(l.TrimStart('#').Trim()));

        /// <summary>A heading as a link has it.</summary>
        public static string Link(string heading)
        {
            var link = new StringBuilder();
            foreach (char c in heading.ToLowerInvariant())
            {
                if (char.IsLetterOrDigit(c) || c == '-' || c == '_') link.Append(c);
                else if (c == ' ') link.Append('-');
            }
            return link.ToString();
        }
    }
}
