using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>Liquid that the Standard method moves.</summary>
    internal static class SolvedStates
    {
        private const int FrameRate = 60, QuickShare = 3;
        private const float WallRim = 4f, SpaceAbove = 7f; // dx

        /// <summary>A pool from wall to wall after two seconds in which it comes to rest: 30 frames of rest.</summary>
        public static SurfaceState Settled(SurfaceScale scale) => Settled(scale, new Vector3Int(21, 8, 21));

        /// <summary>Such a pool of another size.</summary>
        /// <param name="scale">Sizes.</param>
        /// <param name="size">Particles along each axis; as large as the domain along x and z.</param>
        public static SurfaceState Settled(SurfaceScale scale, Vector3Int size)
        {
            SurfaceState state = scale.Empty(new Vector3(size.x, size.y + SpaceAbove, size.z), size.y);
            List<Vector3> places = CaseLattice.Box(size, 1.0, Vector3.zero);
            CaseLattice.Jitter(places, 0.05, 2, float.MaxValue * Vector3.one);
            SurfaceScale.LookAt(state, WallRim * Vector2.one, (size.x - WallRim) * Vector2.one);
            double level = SurfaceScale.Height(state, size.y);
            state.Level = _ => level;
            return Moving(scale, state, places, 120, 30);
        }

        /// <summary>
        /// A dam break of 3,840 particles in a tank 45 dx long, from 0.5 s after the gate has gone, when the front has met the far wall:
        /// 100 frames of splash and of the wave that comes back.
        /// </summary>
        public static SurfaceState DamBreak(SurfaceScale scale)
        {
            var domain = new Vector3(45f, 39f, 12f);
            SurfaceState state = scale.Empty(domain, 20f);
            SurfaceScale.LookAt(state, Vector2.one, new Vector2(domain.x - 1f, domain.z - 1f));
            return Moving(scale, state, CaseLattice.Box(new Vector3Int(16, 20, 12), 1.0, Vector3.zero),
                scale.Quick ? 30 / QuickShare : 30, 100);
        }

        private static SurfaceState Moving(SurfaceScale scale, SurfaceState state, IReadOnlyList<Vector3> start,
            int framesBefore, int frames)
        {
            if (scale.Quick) frames /= QuickShare;
            state.InTime = true;
            state.Volume = start.Count * Math.Pow(SurfaceScale.Spacing, 3);
            state.Planned = (start.Count, frames, (framesBefore + frames) * StepsPerFrame(state));
            state.Prepare = shaders => Play(state, shaders, start, framesBefore, frames);
            return state;
        }

        private static IEnumerator Play(SurfaceState state, FluidShaderSet shaders, IReadOnlyList<Vector3> start,
            int framesBefore, int frames)
        {
            SurfaceScale.Add(state, start);
            FluidParticle[] particles = CaseLattice.Particles(state.Frames[0]);
            state.Frames.Clear();
            int steps = StepsPerFrame(state);
            using (var solver = new FluidSolver(state.Settings, shaders, particles))
            using (var cmd = new CommandBuffer { name = "Surface State" })
            {
                for (int frame = 1 - framesBefore; frame <= frames; frame++)
                {
                    cmd.Clear();
                    solver.RecordSteps(cmd, steps, 1f / (FrameRate * steps));
                    solver.RecordNeighbourSetup(cmd);
                    Graphics.ExecuteCommandBuffer(cmd);
                    if (frame > 0)
                        state.Frames.Add(ById(solver, particles));
                    else
                        solver.ReadCountersNow(); // waits: frames before are not seen
                    yield return null;
                }
            }
        }

        private static int StepsPerFrame(SurfaceState state) => (int)Math.Ceiling(1.0 / FrameRate / state.Settings.TimeStep);

        private static Vector3[] ById(FluidSolver solver, FluidParticle[] particles)
        {
            solver.Particles.GetData(particles);
            return particles.OrderBy(p => p.Id).Select(p => p.Position).ToArray();
        }
    }
}
