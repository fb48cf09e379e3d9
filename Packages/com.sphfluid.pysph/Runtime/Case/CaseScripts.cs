using System.Globalization;
using System.IO;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The scripts of a case, the same for every case but for the number of processes: text assets below Runtime/Resources of this package,
    /// so that the Editor and builds have them alike.
    /// </summary>
    internal static class CaseScripts
    {
        private const string Folder = "SphFluid.PySph/", Ranks = "@RANKS@";

        /// <summary>A script.</summary>
        /// <param name="name">Name of its file in the case.</param>
        /// <param name="ranks">Processes that it starts unless it is told otherwise.</param>
        /// <exception cref="IOException">The project or build does not have it.</exception>
        public static string Text(string name, int ranks)
        {
            var script = Resources.Load<TextAsset>(Folder + name);
            if (script == null)
            {
                throw new FileNotFoundException(
                    $"The script '{name}' is missing from com.sphfluid.pysph. Install the package again, with its folder " +
                    "Runtime/Resources.");
            }
            return script.text.Replace(Ranks, ranks.ToString(CultureInfo.InvariantCulture));
        }
    }
}
