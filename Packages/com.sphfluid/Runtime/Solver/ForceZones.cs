using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The force zones of a liquid on the GPU; no buffer until there is one.</summary>
    internal sealed class ForceZones : IDisposable
    {
        private const string Keyword = "FLUID_ZONES";

        private static readonly int ZonesId = Shader.PropertyToID("_Zones");
        private static readonly int EdgeId = Shader.PropertyToID("_ZoneEdge");

        private readonly ForceZone[] zones = new ForceZone[ForceZone.Most];
        private GraphicsBuffer buffer;

        /// <summary>Number of zones.</summary>
        public int Count { get; private set; }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(buffer);

        /// <summary>Takes over the zones as they are now.</summary>
        /// <returns>Whether one changed.</returns>
        /// <exception cref="ArgumentException">There are more than <see cref="ForceZone.Most"/>.</exception>
        public bool SetZones(IReadOnlyList<ForceZone> now)
        {
            if (now.Count > ForceZone.Most)
            {
                throw new ArgumentException($"A liquid has at most {ForceZone.Most} force zones, and {now.Count} are given.", nameof(now));
            }
            bool changed = Count != now.Count;
            for (int i = 0; i < now.Count; i++)
            {
                ForceZone zone = now[i];
                zone.Uniform.w = now.Count;
                changed |= !zones[i].Equals(zone);
                zones[i] = zone;
            }
            Count = now.Count;
            if (!changed || Count == 0) return changed;
            buffer ??= GpuBuffers.Create("SPH Fluid Force Zones", ForceZone.Most, ForceZone.Stride);
            buffer.SetData(zones);
            return true;
        }

        /// <summary>Records the globals of Shaders/Solver/ForceZones.hlsl.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel with the keyword.</param>
        /// <param name="zones">The zones; null for none.</param>
        /// <param name="edge">Over how much the strength rises from a zone's surface inwards [m].</param>
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, ForceZones zones, float edge)
        {
            bool any = zones != null && zones.Count > 0;
            kernel.SetKeyword(cmd, Keyword, any);
            if (!any) return;
            kernel.SetBuffer(cmd, ZonesId, zones.buffer);
            kernel.SetFloat(cmd, EdgeId, edge);
        }

        public void Dispose() => GpuBuffers.Dispose(ref buffer);
    }
}
