using System;
using System.Collections.Generic;
using System.Text;

namespace SphFluid.Tests
{
    /// <summary>Names that nobody gives to an object, unless to see what happens.</summary>
    internal static class HostileNames
    {
        private static readonly string[] Pieces =
        {
            "'", "''' ", "\"", "\"\"\"", "\\", "\n", "\r\n", "\r", "\t", "\0", "\u0001", "\u007f", "\u0085", "\u2028", "\u202e", "\ufeff",
            "\uffff", "\ud800", "\udc00", "\ud83d\ude00",
            "@READINGS@", "@RANKS@", "@PROBES@", "@", "$(touch PWNED)", "`id`", "${HOME}", "$", "; exit 3 #", "&& false", "| cat",
            "\nimport os\n", "#", "{0}", "{", "%s", "%(name)s",
            "=1+1", ",", "/", "..", "../", ":", "*", "?", "<b>", "CON", "nul", "com1", " ", "-", ".", "Tank", "tank", "\u00e9", "e\u0301",
            "\u212b", "\u00df", "\u6d77", "0", "None",
        };

        /// <summary>Names, the same for the same seed: empty ones, short ones, and some of 100,000 characters.</summary>
        public static IEnumerable<string> Make(int count, int seed)
        {
            var random = new Random(seed);
            for (int i = 0; i < count; i++)
            {
                var name = new StringBuilder();
                for (int left = random.Next(8); left > 0; left--)
                {
                    name.Append(random.Next(4) == 0 ? ((char)random.Next(0x10000)).ToString() : Pieces[random.Next(Pieces.Length)]);
                }
                if (i % 1000 == 500)
                    while (name.Length < 100_000) name.Append(Pieces[random.Next(Pieces.Length)]);
                yield return name.ToString();
            }
        }

        /// <summary>A name as UTF-8 holds it: half a surrogate pair is no character.</summary>
        public static string InUtf8(string name) => Encoding.UTF8.GetString(Encoding.UTF8.GetBytes(name));
    }
}
