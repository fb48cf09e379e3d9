using System;
using System.IO;

namespace SphFluid
{
    /// <summary>Where the pages of the manual are.</summary>
    internal static class FluidManual
    {
        /// <summary>
        /// Folder of the pages on the web, with a slash at its end: where documentationUrl of package.json is. Empty as long as
        /// package.json names none: the pages that came with the package are meant then, which are those of its version.
        /// </summary>
        public const string Site = "";

        /// <summary>Folder in the project of the pages of a package.</summary>
        /// <param name="package">The package's name.</param>
        public static string FolderOf(string package) => $"Packages/{package}/Documentation~/";

        /// <summary>
        /// Address of a page: https://site/tuning.md#profile, or file:///project/Packages/com.sphfluid/Documentation~/tuning.md.
        /// </summary>
        /// <param name="page">Its file's name without the ending.</param>
        /// <param name="heading">Heading on it as a link has it, "size-the-box"; empty: the whole page. Files are opened at their
        /// beginning.</param>
        /// <param name="package">The package whose page it is; the site has those of this package only.</param>
        /// <param name="site"><see cref="Site"/>.</param>
        /// <returns>The address.</returns>
        public static string Address(string page, string heading, string package = FluidPackage.Name, string site = Site)
        {
            if (site.Length > 0 && package == FluidPackage.Name) return site + page + ".md" + (heading.Length > 0 ? "#" + heading : "");
            return new Uri(Path.GetFullPath(FolderOf(package) + page + ".md")).AbsoluteUri;
        }
    }
}
