using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The variants by name.</summary>
    sealed class SurfaceVariants
    {
        readonly Func<FluidShaderSet, SurfaceVariant> create;

        SurfaceVariants(string name, bool quick, Func<FluidShaderSet, SurfaceVariant> create)
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
        public static IReadOnlyList<SurfaceVariants> All { get; } = new[]
        {
            new SurfaceVariants("thesis-0.5", false, shaders => new ThesisVariant(shaders, 0.5f)),
            new SurfaceVariants("thesis-0.75", true, shaders => new ThesisVariant(shaders, 0.75f)),
            new SurfaceVariants("thesis-1", false, shaders => new ThesisVariant(shaders, 1f)),
            new SurfaceVariants("thesis-0.75-low", false, shaders => new ThesisVariant(shaders, 0.75f, 0.12f)),
            new SurfaceVariants("thesis-sparse-0.75", false, shaders => SparseVariant.Thesis(shaders, 0.75f)),
            new SurfaceVariants("cheap", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.Cheap, 1f)),
            new SurfaceVariants("default", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.Default, 0.75f)),
            new SurfaceVariants("high", true, shaders => SparseVariant.Smooth(shaders, FluidSurfaceQuality.High, 0.5f)),
            new SurfaceVariants("cheap-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.Cheap, 1f)),
            new SurfaceVariants("default-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.Default, 0.75f)),
            new SurfaceVariants("high-dual", false, shaders => new DualVariant(shaders, FluidSurfaceQuality.High, 0.5f)),
            new SurfaceVariants("anisotropic-0.5", false, shaders => SparseVariant.Anisotropic(shaders, 0.5f)),
            new SurfaceVariants("anisotropic-0.75", false, shaders => SparseVariant.Anisotropic(shaders, 0.75f)),
            new SurfaceVariants("zhu-bridson-0.75", false, shaders => new ZhuBridsonVariant(shaders, 0.75f)),
            new SurfaceVariants("marching-cubes", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.MarchingCubes)),
            new SurfaceVariants("dual", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.Dual)),
            new SurfaceVariants("dual-flip", false, shaders => new PolygoniserVariant(shaders, SurfacePolygons.DualWithFlip)),
        };

        /// <summary>The variant of a name.</summary>
        public static SurfaceVariants Find(string name) => All.First(v => v.Name == name);

        /// <summary>The variant.</summary>
        /// <param name="shaders">The package's shaders.</param>
        public SurfaceVariant Create(FluidShaderSet shaders) => create(shaders);
    }
}
