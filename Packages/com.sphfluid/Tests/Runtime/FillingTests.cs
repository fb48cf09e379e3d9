using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Shapes of Fluid Volumes in a scene: what is filled, what is said about wrong ones, and relaxed starts.</summary>
    public sealed class FillingTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidVolume volume;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create(liquid: false);
            simulation.Method = FluidMethodKind.Standard;
            simulation.StartJitter = 0f;
            volume = rig.AddVolume(simulation);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void ASphereAndItsMeshHoldTheSame()
        {
            simulation.Spacing = 0.02f;
            volume.Size = 0.24f * Vector3.one;
            volume.Shape = FluidVolumeShape.Sphere;
            volume.InitialVelocity = Vector3.right;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            int ball = simulation.ParticleCount;
            Assert.That(ball, Is.EqualTo(Mathf.PI / 6f * 12f * 12f * 12f).Within(2).Percent);
            Assert.That(SimulationRig.Read(simulation).All(p => p.VelT0 == Vector3.right));

            volume.Shape = FluidVolumeShape.Mesh;
            volume.gameObject.AddComponent<MeshFilter>().sharedMesh = Cube();
            volume.transform.localScale = new Vector3(0.24f, 0.2f, 0.16f);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(12 * 10 * 8));
        }

        [Test]
        public void WrongMeshesAreNamed()
        {
            volume.Shape = FluidVolumeShape.Mesh;
            Fails(FluidIssue.VolumeMeshInvalid, "'Liquid': The liquid volume has no mesh.*Mesh Filter");
            Mesh open = Cube();
            open.triangles = open.triangles.Skip(3).ToArray();
            volume.Mesh = open;
            Fails(FluidIssue.VolumeMeshInvalid, "'Liquid': The liquid volume's mesh 'Cube' is open: 3 edges");
            open.UploadMeshData(true);
            Fails(FluidIssue.VolumeMeshInvalid, "'Liquid': .*cannot be read.*Read/Write");
        }

        [Test]
        public void AVesselThatIsNoneIsReportedWithThePlace()
        {
            volume.Shape = FluidVolumeShape.Vessel;
            volume.Level = 0.1f;
            Fails(FluidIssue.VesselLeaks, "'Liquid': The liquid runs out of the vessel .* near \\(.*Domain Holds");
            volume.DomainHolds = true;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(8 * 8 * 6), "0.2 m below the object and 0.1 m above it");
            volume.Level = 0f;
            Fails(FluidIssue.VolumeSizeInvalid, "'Liquid': The vessel's level is 0 m");
        }

        [UnityTest]
        public IEnumerator ARelaxedStartReportsItsStepsAndKeepsVelocities()
        {
            simulation.DomainSize = new Vector3(0.2f, 0.4f, 0.2f);
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            volume.InitialVelocity = new Vector3(0.5f, 0f, 0f);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            FluidParticle[] lattice = SimulationRig.Read(simulation);
            foreach (FluidStartRelaxation relaxation in new[] { FluidStartRelaxation.Packed, FluidStartRelaxation.Hydrostatic })
            {
                simulation.StartRelaxation = relaxation;
                simulation.StartSimulation();
                Assert.That(simulation.Messages.Count(m => m.Issue == FluidIssue.StartRelaxation && m.Text.Contains("damped steps")),
                    Is.EqualTo(1));
                FluidParticle[] rested = SimulationRig.Read(simulation);
                Assert.That(rested.Length, Is.EqualTo(lattice.Length));
                Assert.That(rested.All(p => p.VelT0 == new Vector3(0.5f, 0f, 0f)));
                float sunk = lattice.Average(p => p.Position.y) - rested.Average(p => p.Position.y);
                if (relaxation == FluidStartRelaxation.Hydrostatic) Assert.That(sunk, Is.GreaterThan(0f));
                simulation.StartSimulation();
                Assert.That(SimulationRig.Read(simulation), Is.EqualTo(rested), "to the last bit");
            }
            simulation.StartRelaxation = FluidStartRelaxation.None;
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.Messages.Any(m => m.Issue == FluidIssue.StartRelaxation), Is.False,
                "another setting starts the liquid again");
        }

        [Test]
        public void TheThesisMethodIsNotRelaxed()
        {
            simulation.Method = FluidMethodKind.Thesis;
            simulation.StartRelaxation = FluidStartRelaxation.Packed;
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid': Start Relaxation needs the method Standard"));
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
        }

        private void Fails(FluidIssue issue, string expected)
        {
            LogAssert.Expect(LogType.Error, new Regex(expected));
            Assert.That(simulation.StartSimulation(), Is.False);
            Assert.That(simulation.Messages.Select(m => m.Issue), Does.Contain(issue));
        }

        private static Mesh Cube()
        {
            Vector3[] corners = Enumerable.Range(0, 8).Select(i => 0.5f * new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1))
                .ToArray();
            return new Mesh
            {
                name = "Cube", vertices = corners,
                triangles =
                    new[] { 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5 }
            };
        }
    }
}
