using System;
using System.Globalization;
using System.Linq;
using System.Security.Cryptography;

namespace SphFluid.Validation
{
    /// <summary>Which program measures: shards of a sweep must be of the same one.</summary>
    internal static class SweepBuild
    {
        /// <summary>The variable of the environment that has the commit; <c>./run</c> sets it where git knows one.</summary>
        public const string CommitVariable = "SPHFLUID_COMMIT";

        /// <summary>The version of the package, as in package.json.</summary>
        public const string Version = "0.2.0";

        /// <summary>
        /// The commit, with a hash of what differs from it; empty where there is none, as in a project that installed the package.
        /// </summary>
        public static string Commit => (Environment.GetEnvironmentVariable(CommitVariable) ?? "").Trim();

        /// <summary>
        /// A hash of both packages' assemblies, equal for equal sources and compilers: what stands in for a commit. Shaders are not in it.
        /// </summary>
        public static string Assemblies
        {
            get;
        } = HashOf(typeof(FluidSolver).Module.ModuleVersionId, typeof(SweepBuild).Module.ModuleVersionId);

        private static string HashOf(params Guid[] modules)
        {
            using (var sha = SHA256.Create())
            {
                byte[] hash = sha.ComputeHash(modules.SelectMany(m => m.ToByteArray()).ToArray());
                return string.Concat(hash.Take(8).Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
            }
        }
    }
}
