using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The surface around a box under water: no gap stays between the two.</summary>
    public sealed class SurfaceAtCollidersTests
    {
        private const float Spacing = 0.025f;
        private const int Deep = 11;

        [TestCase(FluidSurfaceQuality.Cheap, false, 0f)]
        [TestCase(FluidSurfaceQuality.Default, true, 0f)]
        [TestCase(FluidSurfaceQuality.Default, true, 30f)]
        [TestCase(FluidSurfaceQuality.High, true, 0f)]
        public void NoGapIsLeftBeforeTheBox(FluidSurfaceQuality quality, bool hasSpray, float degrees)
        {
            Vector3 domain = Spacing * new Vector3(14f, Deep + 3f, 12f), size = 4f * Spacing * Vector3.one;
            Vector3 centre = Spacing * new Vector3(0f, -1.5f, 0f);
            Quaternion turn = Quaternion.Euler(0f, degrees, 0f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Deep * Spacing);
            settings.Viscosity = 0.02f; // comes to rest soon
            float Outside(Vector3 place)
            {
                Vector3 local = Quaternion.Inverse(turn) * (place - centre);
                local = new Vector3(Math.Abs(local.x), Math.Abs(local.y), Math.Abs(local.z));
                return Vector3.Max(Vector3.zero, local - 0.5f * size).magnitude;
            }
            using (var rig = new BodyRig(settings))
            using (var surface = new SparseSurface(SurfaceTestScene.LoadShaders()))
            {
                Transform box = rig.AddBox(size);
                box.SetPositionAndRotation(centre, turn);
                FluidParticle[] water = WallForceRig.Block(new Vector3Int(14, Deep, 12), Spacing, -0.5f * domain, Vector3.zero)
                    .Where(p => Outside(p.Position) > 0.4f * Spacing).ToArray();
                for (int i = 0; i < water.Length; i++) water[i].Id = (uint)i;
                rig.Start(water);
                rig.Frame(60);
                SurfaceFieldSettings field = SurfaceFieldSettings.For(quality, settings).WithSpray(hasSpray);
                SurfaceMesh mesh = surface.Extract(rig.Solver, field, SurfaceGrid.OverDomain(domain, field.CellSize), SurfaceWalls.Closed);
                float[] gaps = mesh.Positions.Where(p => Outside(p) < 1.5f * Spacing).Select(p => Outside(p) / Spacing).ToArray();
                TestContext.WriteLine($"{quality}: {gaps.Length} vertices, {gaps.Average():F2} dx before the box, {gaps.Max():F2} at most");
                Assert.That(gaps.Length, Is.GreaterThan(40));
                Assert.That(gaps.Count(gap => gap >= 0.03f), Is.LessThan(0.02 * gaps.Length),
                    "one may stand over a hole in a layer of particles; without the pull of walls 0.05 to 0.15 at most");
            }
        }
    }
}
