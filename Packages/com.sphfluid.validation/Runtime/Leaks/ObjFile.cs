using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Triangles of a Wavefront .obj file: lines v and f, everything else is passed over.</summary>
    internal static class ObjFile
    {
        /// <summary>The corners, three a triangle; faces of more corners are cut into fans.</summary>
        /// <exception cref="FileNotFoundException">There is no such file.</exception>
        /// <exception cref="InvalidDataException">A line is none of the format; the message names it.</exception>
        public static Vector3[] Read(string file)
        {
            var places = new List<Vector3>();
            var corners = new List<Vector3>();
            int number = 0;
            foreach (string line in File.ReadLines(file))
            {
                number++;
                string[] words = line.Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
                try
                {
                    if (words.Length > 0 && words[0] == "v")
                        places.Add(new Vector3(Number(words[1]), Number(words[2]), Number(words[3])));
                    else if (words.Length > 0 && words[0] == "f")
                        AddFan(corners, Array.ConvertAll(words, w => w == "f" ? default : places[Index(w, places.Count)]));
                }
                catch (Exception exception) when (exception is FormatException || exception is IndexOutOfRangeException ||
                    exception is ArgumentOutOfRangeException)
                {
                    throw new InvalidDataException($"'{file}' has a broken line {number}: '{line}'.", exception);
                }
            }
            return corners.ToArray();
        }

        // The first place is the word f's.
        private static void AddFan(List<Vector3> corners, Vector3[] face)
        {
            for (int k = 2; k + 1 < face.Length; k++) corners.AddRange(new[] { face[1], face[k], face[k + 1] });
        }

        // Counted from one; negative ones from the end.
        private static int Index(string word, int count)
        {
            int index = int.Parse(word.Split('/')[0], CultureInfo.InvariantCulture);
            return index < 0 ? count + index : index - 1;
        }

        private static float Number(string word) => float.Parse(word, CultureInfo.InvariantCulture);
    }
}
