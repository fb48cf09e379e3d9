using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What the other components of a scene are to one liquid, as they were at the last look; the lists are filled anew at each, so that a frame makes no garbage.</summary>
    internal sealed class SceneParts
    {
        /// <summary>Emitters of the liquid.</summary>
        public List<EmitterSpec> Emitters { get; } = new List<EmitterSpec>();

        /// <summary>Drains of the liquid.</summary>
        public List<DrainSpec> Drains { get; } = new List<DrainSpec>();

        /// <summary>Force zones that act on the liquid.</summary>
        public List<ZoneSpec> Zones { get; } = new List<ZoneSpec>();

        /// <summary>Whose skinned meshes are walls of the liquid.</summary>
        public List<WallSpec> Walls { get; } = new List<WallSpec>();

        /// <summary>Volumes of the liquid.</summary>
        public List<VolumeSpec> Volumes { get; } = new List<VolumeSpec>();

        /// <summary>What plays the liquid; null: it is stepped.</summary>
        public IFluidPlayback Playback { get; set; }

        /// <summary>Number of volumes and emitters: without one there is no liquid.</summary>
        public int SourceCount => Volumes.Count + Emitters.Count;

        /// <summary>A simulation with these parts.</summary>
        /// <param name="spec">The simulation without.</param>
        public FluidSpec AddedTo(FluidSpec spec)
        {
            spec.Emitters = Emitters;
            spec.Drains = Drains;
            spec.Zones = Zones;
            spec.Walls = Walls;
            return spec;
        }
    }
}
