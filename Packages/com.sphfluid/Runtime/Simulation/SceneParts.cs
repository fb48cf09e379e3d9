using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// What the other components of a scene are to one liquid, as they were at the last look; the lists are filled anew at each, so that a
    /// frame makes no garbage.
    /// </summary>
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

        /// <summary>How much detail it is worth now.</summary>
        public FluidDetail Detail { get; set; }

        /// <summary>
        /// A number that another number or setting of volumes, emitters and zones changes: what keeps a liquid from starting is tried again
        /// then. NaN is the same as NaN.
        /// </summary>
        public int Sources
        {
            get
            {
                var all = new HashCode();
                foreach (VolumeSpec volume in Volumes)
                {
                    all.Add((volume.Shape, volume.Size, volume.FilledMesh, volume.Level, volume.DomainHolds, volume.InitialVelocity));
                }
                foreach (EmitterSpec emitter in Emitters)
                {
                    all.Add((emitter.Shape, emitter.Size, emitter.Mesh, emitter.Flow, emitter.Amount, emitter.Lifetime,
                        emitter.UnderWater));
                }
                foreach (ZoneSpec zone in Zones)
                {
                    all.Add((zone.Kind, zone.Shape, zone.Size, zone.Strength, zone.WindSpeed, zone.DragRate,
                        (zone.EddySize, zone.EddyTime)));
                }
                return all.ToHashCode();
            }
        }

        /// <summary>A simulation with these parts.</summary>
        /// <param name="spec">The simulation without.</param>
        public FluidSpec AddedTo(FluidSpec spec)
        {
            spec.Emitters = Emitters;
            spec.Drains = Drains;
            spec.Zones = Zones;
            spec.Walls = Walls;
            spec.Detail = Detail;
            return spec;
        }
    }
}
