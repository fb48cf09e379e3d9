using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>All shaders of the package, by the parts that have them.</summary>
    internal static class PackageShaders
    {
        /// <summary>
        /// The groups: one for each method's folder and for what methods share, and those of surface, drawing and diagnostics.
        /// </summary>
        public static IReadOnlyList<ShaderGroup> Groups
        {
            get
            {
                var groups = new List<ShaderGroup>();
                foreach (ShaderGroup group in FluidMethods.ShaderGroups)
                {
                    groups.Add(group);
                    if (group.Shared != null && !groups.Contains(group.Shared)) groups.Add(group.Shared);
                }

                groups.AddRange(FluidMethods.SurfaceGroups);
                groups
                    .AddRange(new[] { ShaderGroup.Simulation, ShaderGroup.Surface, ShaderGroup.Drawing, ShaderGroup.Diagnostics,
                        QueryKind.Shaders, ShaderGroup.WallForces, ShaderGroup.Whitewater });
                return groups;
            }
        }

        /// <summary>Names of those that a shader set has not.</summary>
        public static IReadOnlyList<string> Missing(FluidShaderSet set)
        {
            var missing = new List<string>();
            foreach (ShaderGroup group in Groups) missing.AddRange(set.Missing(group.Shaders));
            return missing;
        }
    }
}
