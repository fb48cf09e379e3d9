using System;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The package's liquids by names for the command line; a test holds them to its folder of liquids.</summary>
    public static class PackageLiquids
    {
        internal const string Folder = "Packages/com.sphfluid/Runtime/Assets/Liquids";

        /// <summary>The names: <c>sea-water</c> is the asset <c>Sea Water</c>.</summary>
        public static readonly string[] Names =
        {
            "blood", "honey", "lava", "mercury", "milk", "muddy-river", "oil", "sea-water", "slime", "water",
        };

        /// <summary>The asset of a name, in the Editor and the headless player.</summary>
        /// <exception cref="CommandLineException">It is not there.</exception>
        public static FluidLiquid Load(string name)
        {
            string path = $"{Folder}/{AssetName(name)}.asset";
            return SessionAssets.Load<FluidLiquid>(path) ??
                throw new CommandLineException(
                    $"--liquid {name}: '{path}' is not there; install the package under its name, com.sphfluid.");
        }

        internal static string AssetName(string name) =>
            string.Join(" ", name.Split('-').Select(word => char.ToUpperInvariant(word[0]) + word.Substring(1)));
    }
}
