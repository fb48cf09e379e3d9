using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What somebody may have meant who mistyped a word.</summary>
    internal static class NearestWord
    {
        /// <summary>
        /// The word with the fewest letters to insert, drop, replace or swap with the next one: "--szie" is one swap from "--size" (optimal
        /// string alignment distance). Empty where none is near: more than a third of the letters differ.
        /// </summary>
        public static string Of(string word, IEnumerable<string> known)
        {
            string nearest = "";
            int least = Math.Max(1, word.TrimStart('-').Length / 3) + 1;
            foreach (string candidate in known)
            {
                int distance = Distance(word, candidate);
                if (distance < least) (nearest, least) = (candidate, distance);
            }
            return nearest;
        }

        /// <summary>Part of a sentence: "; did you mean --size?", or a full stop where nothing is near.</summary>
        public static string Question(string word, IEnumerable<string> known)
        {
            string nearest = Of(word, known);
            return nearest.Length > 0 ? $"; did you mean {nearest}?" : ".";
        }

        private static int Distance(string a, string b)
        {
            var d = new int[a.Length + 1, b.Length + 1];
            for (int i = 0; i <= a.Length; i++) d[i, 0] = i;
            for (int j = 0; j <= b.Length; j++) d[0, j] = j;
            for (int i = 1; i <= a.Length; i++)
            {
                for (int j = 1; j <= b.Length; j++)
                {
                    int replaced = d[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
                    d[i, j] = Math.Min(replaced, Math.Min(d[i - 1, j], d[i, j - 1]) + 1);
                    if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i, j] = Math.Min(d[i, j], d[i - 2, j - 2] + 1);
                }
            }
            return d[a.Length, b.Length];
        }
    }
}
