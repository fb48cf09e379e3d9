using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The report's page: its parts are text assets of this package beside this file, in the folder Page.</summary>
    internal sealed class ReportPage
    {
        private const string Folder = "Packages/com.sphfluid.validation/Runtime/Chart/Report/Page/";

        private static readonly string[] scripts = { "numbers", "elements", "panel", "curves", "page" };

        private readonly string page, style, script;

        private ReportPage(string page, string style, string script)
        {
            this.page = page;
            this.style = style;
            this.script = script;
        }

        /// <summary>The page, in the Editor and the headless player; null elsewhere, where the package's assets cannot be read.</summary>
        public static ReportPage Load()
        {
            string page = Text("report.html"), style = Text("report.css.txt");
            string[] parts = scripts.Select(s => Text(s + ".js.txt")).ToArray();
            return page == null || style == null || parts.Any(p => p == null) ? null
                : new ReportPage(page, style, string.Join("\n", parts));
        }

        /// <summary>The page's text with its places filled in.</summary>
        /// <param name="parts">A place's name and the HTML for it.</param>
        /// <exception cref="ArgumentException">The page has no such place, or one is left.</exception>
        public string Fill(IReadOnlyDictionary<string, string> parts)
        {
            var all = parts.ToDictionary(p => p.Key, p => p.Value);
            all.Add("style", style);
            all.Add("script", script);
            // Between the places stands the page, at the places what belongs there: what is filled in is not looked through again.
            string[] pieces = page.Split(new[] { "{{", "}}" }, StringSplitOptions.None);
            var left = new HashSet<string>(all.Keys);
            for (int i = 1; i < pieces.Length; i += 2)
            {
                string name = pieces[i];
                if (!all.TryGetValue(name, out pieces[i]))
                {
                    throw new ArgumentException($"report.html has a place for '{name}', which nothing fills.", nameof(parts));
                }
                left.Remove(name);
            }
            if (left.Count > 0) throw new ArgumentException($"report.html has no place for '{left.First()}'.", nameof(parts));
            return string.Concat(pieces);
        }

        // Unity gives a text as it is, whatever its line endings are.
        private static string Text(string file)
        {
            TextAsset asset = SessionAssets.Load<TextAsset>(Folder + file);
            return asset == null ? null : asset.text.Replace("\r\n", "\n");
        }
    }
}
