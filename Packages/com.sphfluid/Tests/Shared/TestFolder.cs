using System;
using System.IO;

namespace SphFluid.Tests
{
    /// <summary>Folders of a test's own.</summary>
    internal static class TestFolder
    {
        /// <summary>A path among the temporary files where nothing is.</summary>
        public static string Fresh() => Path.Combine(Path.GetTempPath(), "sphfluid-" + Guid.NewGuid().ToString("N"));

        /// <summary>Deletes a folder with all that is in it, if it is there.</summary>
        public static void Delete(string folder)
        {
            if (Directory.Exists(folder)) Directory.Delete(folder, true);
        }
    }
}
