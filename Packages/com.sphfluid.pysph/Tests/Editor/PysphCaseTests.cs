using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The files of a case.</summary>
    public sealed class PysphCaseTests
    {
        private static readonly ExportConstants Constants = new ExportConstants
        {
            DomainSize = new Vector3(1.8f, 1.2f, 0.8f), Spacing = 0.025f, Density = 998f, Viscosity = 1e-6f, SoundSpeed = 21.5f,
            Gravity = new Vector3(0f, -9.81f, 0f),
            Boundaries = new FluidBoundaries { Open = FluidFaces.HighY | FluidFaces.LowX, Periodic = FluidAxes.Z },
        };

        private string path;

        [SetUp]
        public void SetUp() => path = TestFolder.Fresh();

        [TearDown]
        public void TearDown() => TestFolder.Delete(path);

        private static PysphCase Case(string scene = "Dam Break", FluidExportScheme scheme = FluidExportScheme.WeaklyCompressible) =>
            new PysphCase("Tank", Constants,
                new FluidExportOptions { Scene = scene, Seconds = 0.5, FrameRate = 60.0, Ranks = 7, Scheme = scheme, Commit = "abc" })
            {
                Liquid = new LiquidParticle[3],
                Walls = new WallParticle[2],
                Bodies = new[] { new ExportBody("Paddle", new WallParticle[5], new[] { new BodyPose { Rotation = Quaternion.identity } }) },
            };

        private string Written(PysphCase made, string name)
        {
            made.Write(path);
            return File.ReadAllText(Path.Combine(path, name));
        }

        [Test]
        public void EveryFileIsThereAndInTheManifest()
        {
            long bytes = Case().Write(path);

            string[] names = Directory.GetFiles(path).Select(Path.GetFileName).OrderBy(n => n, StringComparer.Ordinal).ToArray();
            Assert.That(names, Is.EqualTo(new[]
            {
                "body-000-path.npy", "body-000.npy", "case.py", "job.sbatch", "liquid.npy", "manifest.json", "run.sh", "to_sequence.py",
                "walls.npy",
            }));
            ExportManifest manifest = JsonUtility.FromJson<ExportManifest>(File.ReadAllText(Path.Combine(path, "manifest.json")));
            Assert.That(manifest.files.Select(f => f.name), Is.EquivalentTo(names.Where(n => n != "manifest.json")));
            Assert.That(manifest.files.Sum(f => f.bytes),
                Is.EqualTo(bytes).And.EqualTo(manifest.files.Sum(f => new FileInfo(Path.Combine(path, f.name)).Length)));
            Assert.That((manifest.liquidParticles, manifest.wallParticles, manifest.bodies[0].name, manifest.bodies[0].particles),
                Is.EqualTo((3L, 2L, "Paddle", 5L)));
            Assert.That((manifest.scene, manifest.simulation, manifest.scheme, manifest.commit, manifest.packageVersion),
                Is.EqualTo(("Dam Break", "Tank", "WCSPH", "abc", FluidPackage.Version)));
            Assert.That(manifest.openFaces, Is.EqualTo(new[] { "LowX", "HighY" }));
            Assert.That(manifest.domainSize, Is.EqualTo(new[] { 1.8, 1.2, 0.8 }));
            Assert.That(manifest.spacing, Is.EqualTo(0.025));
        }

        [Test]
        public void NoPlaceholderIsLeft([Values] FluidExportScheme scheme)
        {
            PysphCase made = Case(scheme: scheme);
            made.Instruments = new[] { new ExportInstrument { Name = "Probe", Property = "p" },
                new ExportInstrument { Name = "Gauge", Property = "height", Up = Vector3.up, Length = 1f } };
            made.Write(path);

            foreach (string name in new[] { "case.py", "to_sequence.py", "readings.py", "run.sh", "job.sbatch" })
            {
                Assert.That(File.ReadAllText(Path.Combine(path, name)), Does.Not.Match("@[A-Z]+@").And.Not.Contain("\r"), name);
            }
        }

        [Test]
        public void ConstantsAreInTheManifest()
        {
            ExportManifest manifest = JsonUtility.FromJson<ExportManifest>(Written(Case(), "manifest.json"));

            Assert.That((manifest.spacing, manifest.density, manifest.viscosity, manifest.soundSpeed, manifest.seconds, manifest.frameRate),
                Is.EqualTo((0.025, 998.0, 1e-6, 21.5, 0.5, 60.0)));
            Assert.That(manifest.gravity, Is.EqualTo(new[] { 0.0, -9.81, 0.0 }));
            Assert.That(manifest.domainSize, Is.EqualTo(new[] { 1.8, 1.2, 0.8 }));
            Assert.That(manifest.periodicAxes, Is.EqualTo(new[] { "Z" }));
        }

        [Test]
        public void WithoutWallsThereIsNoFileOfThem()
        {
            PysphCase made = Case();
            made.Walls = Array.Empty<WallParticle>();

            Assert.That(JsonUtility.FromJson<ExportManifest>(Written(made, "manifest.json")).wallParticles, Is.Zero);
            Assert.That(File.Exists(Path.Combine(path, "walls.npy")), Is.False);
        }

        [Test]
        public void WhatIsNotExportedIsInTheManifest()
        {
            PysphCase made = Case();
            made.Messages = new List<FluidMessage>
            {
                new FluidMessage(FluidSeverity.Warning, FluidIssue.NotExported, null, "A drain.", "None."),
                new FluidMessage(FluidSeverity.Info, FluidIssue.MethodChoice, null, "Other.", ""),
            };
            ExportManifest manifest = JsonUtility.FromJson<ExportManifest>(Written(made, "manifest.json"));

            Assert.That(manifest.notExported.Select(n => (n.name, n.text, n.cure)),
                Is.EqualTo(new[] { ("SPH Fluid", "A drain.", "None.") }));
        }
    }
}
