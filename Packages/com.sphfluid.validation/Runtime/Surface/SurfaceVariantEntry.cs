using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A variant by name.</summary>
    internal sealed class SurfaceVariantEntry
    {
        private readonly Func<FluidShaderSet, SurfaceVariant> create;

        private SurfaceVariantEntry(string name, bool quick, Func<FluidShaderSet, SurfaceVariant> create)
        {
            Name = name;
            Quick = quick;
            this.create = create;
        }

        /// <summary>Name on the command line.</summary>
        public string Name { get; }

        /// <summary>Whether it is among those of a quick measurement.</summary>
        public bool Quick { get; }

        /// <summary>All.</summary>
        public static IReadOnlyList<SurfaceVariantEntry> All { get; } = new[]
        {
            new SurfaceVariantEntry("thesis-0.5", false, shaders => new ThesisVariant(shaders, 0.5f)),
            new SurfaceVariantEntry("thesis-0.75", true, shaders => new ThesisVariant(shaders, 0.75f)),
            new SurfaceVariantEntry("thesis-1", false, shaders => new ThesisVariant(shaders, 1f)),
            new SurfaceVariantEntry("thesis-0.75-low", false, shaders => new ThesisVariant(shaders, 0.75f, 0.12f)),
            new SurfaceVariantEntry("thesis-sparse-0.75", false, shaders => SparseVariant.Thesis(shaders, 0.75f)),
            new SurfaceVariantEntry("cheap", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.Cheap, 1f)),
            new SurfaceVariantEntry("default", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.Default, 0.75f)),
            new SurfaceVariantEntry("default-spray", true, shaders => SparseVariant.Spray(shaders)),
            new SurfaceVariantEntry("high", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.High, 0.5f)),
            new SurfaceVariantEntry("cheap-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.Cheap, 1f)),
            new SurfaceVariantEntry("default-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.Default, 0.75f)),
            new SurfaceVariantEntry("high-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.High, 0.5f)),
            new SurfaceVariantEntry("anisotropic-0.5", false, shaders => SparseVariant.Anisotropic(shaders, 0.5f)),
            new SurfaceVariantEntry("anisotropic-0.75", false, shaders => SparseVariant.Anisotropic(shaders, 0.75f)),
            new SurfaceVariantEntry("zhu-bridson-0.75", false, shaders => new ZhuBridsonVariant(shaders, 0.75f)),
            new SurfaceVariantEntry("marching-cubes", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.MarchingCubes)),
            new SurfaceVariantEntry("dual", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.Dual)),
            new SurfaceVariantEntry("dual-flip", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.DualWithFlip)),
        };

        /// <summary>The variant of a name.</summary>
        public static SurfaceVariantEntry Find(string name) => All.First(v => v.Name == name);

        /// <summary>The variant.</summary>
        /// <param name="shaders">The package's shaders.</param>
        public SurfaceVariant Create(FluidShaderSet shaders) => create(shaders);
    }
}
