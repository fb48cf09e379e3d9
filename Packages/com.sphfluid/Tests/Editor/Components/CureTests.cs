using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Each cure that a message before the start proposes is tried: after it neither the message nor another one is there. Those during
    /// play are in CuresDuringPlayTests.
    /// </summary>
    public sealed class CureTests
    {
        private const string Number = @"([0-9.,E-]*[0-9])";

        private const string WaterPath = "Packages/com.sphfluid/Runtime/Assets/Liquids/Water.asset";

        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidVolume volume;
        private GameObject other;
        private Match said;

        private static readonly (string name, string says, Action<CureTests> cause,
            (string words, Action<CureTests> apply)[] cures)[] Cases =
        {
            ("no profile", "No liquid is assigned", t => t.simulation.Profile = null,
                new (string, Action<CureTests>)[]
            {
                ("Assign a Fluid Liquid", t => t.simulation.Liquid = TestAssets.Load<FluidLiquid>(WaterPath)),
                ("or a Fluid Profile", t => t.simulation.Profile = t.rig.Profile),
            }),
            ("no shaders", "no shader set", t => t.rig.Profile.Shaders = null,
                new (string, Action<CureTests>)[] { ("DefaultFluidShaderSet", t => t.rig.Profile.Shaders = TestAssets.Water.Shaders) }),
            ("scaled", "needs scale 1", t => t.simulation.transform.localScale = 2f * Vector3.one,
                new (string,
                    Action<CureTests>)[] { ("scale of this object and its parents to 1",
                        t => t.simulation.transform.localScale = Vector3.one) }),
            ("coarse", "less than two particles", t => t.simulation.Spacing = 0.3f, new (string, Action<CureTests>)[]
            {
                ("smaller Particle Spacing", t => t.simulation.Spacing = 0.1f),
                ("larger Domain Size", t => t.Grow(4f)),
            }),
            ("fixed step", $"above the stability limit.*Fixed Time Step of {Number} s", t => t.Fix(0.1f), new (string, Action<CureTests>)[]
            {
                ("Use a Fixed Time Step of", t => t.simulation.FixedTimeStep = t.Said),
                ("Time Step Mode to Automatic", t => t.simulation.TimeStepMode = FluidTimeStepMode.Automatic),
            }),
            ("fixed step of thick liquid", $"kinematic viscosity.*Fixed Time Step of {Number} s", t => t.Thick(),
                new (string, Action<CureTests>)[]
            {
                ("Use a Fixed Time Step of", t => t.simulation.FixedTimeStep = t.Said),
                ("Time Step Mode to Automatic", t => t.simulation.TimeStepMode = FluidTimeStepMode.Automatic),
            }),
            ("deep Robust", $"carries liquid of this depth.*Substeps to {Number} or more", t => t.Deep(), new (string, Action<CureTests>)[]
            {
                ("Raise the profile's Substeps", t => t.rig.Profile.Substeps = (int)t.Said),
                ("larger Particle Spacing", t => t.simulation.Spacing = 0.04f),
            }),
            ("no liquid", "holds no liquid", t => Object.DestroyImmediate(t.volume.gameObject), new (string, Action<CureTests>)[]
            {
                ("Add a Fluid Volume", t => t.rig.AddVolume(t.simulation)),
                ("Fluid Emitter", t => t.Emitter(Vector3.zero)),
            }),
            ("volume outside", "lies outside the domain", t => t.volume.transform.localPosition = 0.6f * Vector3.right,
                new (string, Action<CureTests>)[]
            {
                ("Move it into the domain", t => t.volume.transform.localPosition = Vector3.zero),
                ("enlarge the simulation's Domain Size", t => t.Grow(4f)),
            }),
            ("volume partly outside", "% of the liquid volume lies outside", t => t.volume.transform.localPosition = 0.2f * Vector3.right,
                new (string, Action<CureTests>)[]
            {
                ("Move", t => t.volume.transform.localPosition = 0.1f * Vector3.right),
                ("shrink the volume", t => (t.volume.Size, t.volume.transform.localPosition) = (0.1f * Vector3.one, 0.15f * Vector3.right)),
                ("enlarge the simulation's Domain Size", t => t.Grow(2f)),
            }),
            ("flat volume", "zero or non-finite scale", t => t.volume.transform.localScale = new Vector3(1f, 0f, 1f),
                new (string, Action<CureTests>)[] { ("a scale without zeros", t => t.volume.transform.localScale = Vector3.one) }),
            ("volume in a collider", "wholly inside colliders", t => t.Box(Vector3.zero, 0.3f * Vector3.one),
                new (string, Action<CureTests>)[]
            {
                ("Move the volume out of the collider",
                    t => (t.other.transform.position, t.volume.transform.localPosition) =
                        (new Vector3(-0.25f, 0f, 0f), 0.1f * Vector3.right)),
                ("out of the simulation's Collider Layers", t => t.simulation.ColliderLayers = 0),
            }),
            ("collider in the volume", "would start inside colliders", t => t.Box(new Vector3(0.1f, 0f, 0f), 0.15f * Vector3.one),
                new (string,
                    Action<CureTests>)[] { ("move the volume and the collider apart",
                        t => t.other.transform.position = 0.18f * Vector3.up) }),
            ("many particles", $"needs .* particles.*Particle Spacing of {Number} m or more", t => t.rig.Profile.MaxParticles = 30,
                new (string, Action<CureTests>)[]
            {
                ("Use a Particle Spacing of", t => t.simulation.Spacing = t.Said),
                ("less liquid", t => t.volume.Size = 0.15f * Vector3.one),
                ("raise Max Particles", t => t.rig.Profile.MaxParticles = 64),
            }),
            ("many cells", $"cells for the neighbour search.*Particle Spacing of {Number} m or more",
                t => t.simulation.DomainSize = new Vector3(4000f, 4000f, 4000f), new (string, Action<CureTests>)[]
            {
                ("smaller Domain Size", t => t.simulation.DomainSize = 0.4f * Vector3.one),
                ("or a Particle Spacing of", t => (t.simulation.Spacing, t.volume.Size) = (t.Said, 4f * t.Said * Vector3.one)),
            }),
            ("collider without a mesh", "has no mesh, so", t => t.Add<MeshCollider>(), new (string, Action<CureTests>)[]
            {
                ("Assign a mesh to the Mesh Collider", t => t.GiveMesh()),
                ("or remove it", t => Object.DestroyImmediate(t.other.GetComponent<MeshCollider>())),
            }),
            ("collider of an empty mesh", "has no triangles", t => t.Add<MeshCollider>().sharedMesh = new Mesh { name = "Nothing" },
                new (string, Action<CureTests>)[]
            {
                ("Assign a mesh with triangles", t => t.GiveMesh()),
                ("or remove it", t => Object.DestroyImmediate(t.other.GetComponent<MeshCollider>())),
            }),
            ("collider of flat triangles", "None of its triangles",
                t => t.Add<MeshCollider>().sharedMesh =
                    new Mesh { name = "Lines", vertices = new Vector3[3], triangles = new[] { 0, 1, 2 } },
                new (string, Action<CureTests>)[] { ("a mesh with triangles that have an area", t => t.GiveMesh()) }),
            ("flat collider", "transform has a zero",
                t => t.Box(0.18f * Vector3.up, 0.02f * Vector3.one).transform.localScale = new Vector3(1f, 0f, 1f),
                new (string, Action<CureTests>)[] { ("a scale without zeros", t => t.other.transform.localScale = Vector3.one) }),
            ("collider without a size", "zero or non-finite size", t => t.Box(0.18f * Vector3.up, Vector3.zero),
                new (string, Action<CureTests>)[]
            {
                ("a size greater than zero", t => t.other.GetComponent<BoxCollider>().size = 0.02f * Vector3.one),
                ("or remove it", t => Object.DestroyImmediate(t.other.GetComponent<BoxCollider>())),
            }),
            ("friction of a Thesis collider", "has a friction of its own", t => t.OwnFriction(), new (string, Action<CureTests>)[]
            {
                ("Method to Standard", t => t.simulation.Method = FluidMethodKind.Standard),
                ("turn Own Friction off", t => t.other.GetComponent<FluidCollider>().OwnFriction = false),
            }),
            ("collider at a periodic face", $"ends at a periodic face.*Keep it {Number} m or more inside", t => t.AtFace(),
                new (string, Action<CureTests>)[]
            {
                ("inside the faces", t => t.other.transform.position = (0.2f - t.Said - 0.01f) * Vector3.right),
                ("reach as far beyond both", t => t.other.GetComponent<BoxCollider>().size = new Vector3(1.5f, 0.02f, 0.02f)),
                ("take X out of Boundaries.Periodic", t => t.simulation.Boundaries = default),
            }),
            ("volume of no mesh", "has no mesh.", t => t.volume.Shape = FluidVolumeShape.Mesh, new (string, Action<CureTests>)[]
            {
                ("Assign a closed mesh", t => (t.volume.Mesh, t.volume.transform.localScale) = (TestMeshes.Cube(), 0.2f * Vector3.one)),
                ("add a Mesh Filter", t => t.volume.gameObject.AddComponent<MeshFilter>().sharedMesh = Small(TestMeshes.Cube())),
            }),
            ("volume of an open mesh", "is open", t => (t.volume.Shape, t.volume.Mesh) = (FluidVolumeShape.Mesh, Open()),
                new (string, Action<CureTests>)[] { ("Close the mesh's holes", t => t.volume.Mesh = Small(TestMeshes.Cube())) }),
            ("leaking vessel", $"runs out of the vessel over its rim.*Set Level to {Number} m or less", t => t.Vessel(0.2f),
                new (string, Action<CureTests>)[]
            {
                ("Set Level to", t => t.volume.Level = t.Said),
                ("switch Domain Holds on", t => t.volume.DomainHolds = true),
            }),
            ("drain without a volume", "has no volume", t => t.Drain().Size = Vector3.zero,
                new (string,
                    Action<CureTests>)[] { ("numbers greater than zero",
                        t => t.other.GetComponent<FluidDrain>().Size = 0.1f * Vector3.one) }),
            ("drain with another collider", "is no Box, Sphere or Capsule",
                t => t.Drain().gameObject.AddComponent<MeshCollider>().sharedMesh = Small(TestMeshes.Cube()),
                new (string, Action<CureTests>)[]
            {
                ("Use one of these colliders", t => t.Instead<BoxCollider>().isTrigger = true),
                ("an object without a collider", t => Object.DestroyImmediate(t.other.GetComponent<MeshCollider>())),
            }),
            ("emitter of the Thesis", "a fixed number of particles", t => t.Emitter(Vector3.zero, FluidMethodKind.Thesis),
                new (string, Action<CureTests>)[] { ("Method to Standard", t => t.simulation.Method = FluidMethodKind.Standard) }),
            ("emitter outside", "outside the domain", t => t.Emitter(0.3f * Vector3.up), new (string, Action<CureTests>)[]
            {
                ("Move it into the domain", t => t.other.transform.localPosition = 0.15f * Vector3.up),
                ("enlarge Domain Size", t => t.Grow(2f)),
            }),
            ("emitter in a collider", "is inside the collider", t => t.InBox(), new (string, Action<CureTests>)[]
            {
                ("Move the emitter to the opening", t => t.other.transform.localPosition = 0.05f * Vector3.up),
                ("out of Collider Layers", t => t.simulation.ColliderLayers = 0),
            }),
            ("emitter without a size", "The nozzle's size", t => t.Emitter(0.15f * Vector3.up).Size = Vector2.zero,
                new (string,
                    Action<CureTests>)[] { ("two numbers greater than zero",
                        t => t.other.GetComponent<FluidEmitter>().Size = 0.1f * Vector2.one) }),
            ("wide emitter", "particles a layer", t => t.Emitter(0.15f * Vector3.up).Size = 1000f * Vector2.one,
                new (string,
                    Action<CureTests>)[] { ("smaller Size", t => t.other.GetComponent<FluidEmitter>().Size = 0.1f * Vector2.one) }),
            ("fast emitter", $"m/s are the most", t => t.Emitter(0.15f * Vector3.up).Speed = 2000f,
                new (string, Action<CureTests>)[] { ("less Speed", t => t.other.GetComponent<FluidEmitter>().Speed = 1f) }),
            ("emitter of no mesh", "has no mesh", t => t.Emitter(0.15f * Vector3.up).Shape = FluidEmitterShape.Mesh,
                new (string, Action<CureTests>)[]
            {
                ("Assign a mesh",
                    t => (t.other.GetComponent<FluidEmitter>().Mesh, t.other.transform.localScale) =
                        (TestMeshes.Cube(), 0.1f * Vector3.one)),
                ("choose another Shape", t => t.other.GetComponent<FluidEmitter>().Shape = FluidEmitterShape.Disc),
            }),
            ("zones of the Thesis", "has no force zones", t => t.Zone(FluidMethodKind.Thesis),
                new (string, Action<CureTests>)[] { ("Method to Standard", t => t.simulation.Method = FluidMethodKind.Standard) }),
            ("zone of no collider", "has no Box, Sphere or Capsule Collider", t => t.Zone().Shape = FluidZoneShape.Collider,
                new (string, Action<CureTests>)[]
            {
                ("Add one of these, as a trigger", t => t.other.AddComponent<BoxCollider>().isTrigger = true),
                ("choose another Shape", t => t.other.GetComponent<FluidForceZone>().Shape = FluidZoneShape.Box),
            }),
            ("wall that moves across", "Boundaries.LowX",
                t => t.simulation.Boundaries = new FluidBoundaries { Friction = 1f, LowX = new Vector3(1f, 0f, 0f) },
                new (string,
                    Action<CureTests>)[] { ("X component to zero",
                        t => t.simulation.Boundaries = new FluidBoundaries { Friction = 1f, LowX = new Vector3(0f, 1f, 0f) }) }),
        };

        private static IEnumerable<TestCaseData> All =>
            Cases.SelectMany((c, i) => c.cures.Select((cure, k) => new TestCaseData(i, k).SetName($"{c.name}: {cure.words}")));

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create(liquid: false);
            volume = rig.AddVolume(simulation);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [TestCaseSource(nameof(All))]
        public void TheCureCures(int number, int cure)
        {
            (string name, string says, Action<CureTests> cause, (string words, Action<CureTests> apply)[] cures) = Cases[number];
            Assert.That(simulation.Validate(), Is.Empty, "before");
            cause(this);
            Physics.SyncTransforms();
            string[] messages = simulation.Validate().Select(m => m.ToString()).ToArray();
            said = messages.Select(m => Regex.Match(m, says)).FirstOrDefault(m => m.Success);
            Assert.That(said, Is.Not.Null, $"'{says}' is in none of: {string.Join(" | ", messages)}");
            string message = messages.First(m => Regex.IsMatch(m, says));
            Assert.That(message, Does.Contain(cures[cure].words));
            cures[cure].apply(this);
            Physics.SyncTransforms();
            // A vessel's lattice has places in its walls.
            Assert.That(simulation.Validate().Select(m => m.ToString())
                .Where(m => volume == null || volume.Shape != FluidVolumeShape.Vessel || !m.Contains("against their faces")),
                Is.Empty, message);
        }

        private float Said => float.Parse(said.Groups[1].Value, CultureInfo.InvariantCulture);

        private void Grow(float times) => simulation.DomainSize *= times;

        private void Fix(float step) => (simulation.TimeStepMode, simulation.FixedTimeStep) = (FluidTimeStepMode.Fixed, step);

        private void Thick()
        {
            Fix(0.1f);
            simulation.Method = FluidMethodKind.Thesis;
            (rig.Profile.SupportRatio, rig.Profile.KinematicViscosity) = (2f, 0.5f);
        }

        private void Deep()
        {
            (simulation.Method, rig.Profile.Substeps) = (FluidMethodKind.Robust, 1);
            simulation.DomainSize = new Vector3(0.1f, 3f, 0.1f);
            simulation.Spacing = 0.01f;
            volume.Size = simulation.DomainSize;
        }

        private T Add<T>() where T : Component
        {
            other = rig.NewObject("Other");
            other.transform.position = 0.18f * Vector3.up;
            other.transform.localScale = 0.02f * Vector3.one;
            return other.AddComponent<T>();
        }

        private void GiveMesh() => other.GetComponent<MeshCollider>().sharedMesh = TestMeshes.Cube();

        private BoxCollider Box(Vector3 place, Vector3 size)
        {
            other = rig.NewObject("Box");
            other.transform.position = place;
            BoxCollider box = other.AddComponent<BoxCollider>();
            box.size = size;
            return box;
        }

        private void AtFace()
        {
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            Box(new Vector3(0.2f, 0.18f, 0f), 0.02f * Vector3.one);
        }

        private void OwnFriction()
        {
            (simulation.Method, rig.Profile.SupportRatio) = (FluidMethodKind.Thesis, 2f);
            Box(0.18f * Vector3.up, 0.02f * Vector3.one).gameObject.AddComponent<FluidCollider>().OwnFriction = true;
        }

        private T Child<T>(string name, Vector3 place) where T : Component
        {
            other = new GameObject(name) { layer = 0 };
            other.transform.SetParent(simulation.transform, false);
            other.transform.localPosition = place;
            return other.AddComponent<T>();
        }

        private FluidDrain Drain() => Child<FluidDrain>("Drain", Vector3.zero);

        private FluidEmitter Emitter(Vector3 place, FluidMethodKind method = FluidMethodKind.Standard)
        {
            simulation.Method = method;
            if (method == FluidMethodKind.Thesis) rig.Profile.SupportRatio = 2f;
            FluidEmitter emitter = Child<FluidEmitter>("Emitter", place);
            (emitter.Size, emitter.Speed) = (0.1f * Vector2.one, 0.5f);
            return emitter;
        }

        private FluidForceZone Zone(FluidMethodKind method = FluidMethodKind.Standard)
        {
            simulation.Method = method;
            if (method == FluidMethodKind.Thesis) rig.Profile.SupportRatio = 2f;
            return Child<FluidForceZone>("Zone", Vector3.zero);
        }

        private void InBox()
        {
            volume.transform.localPosition = -0.1f * Vector3.up;
            Box(0.16f * Vector3.up, new Vector3(0.3f, 0.08f, 0.3f));
            Emitter(0.16f * Vector3.up);
        }

        private T Instead<T>() where T : Collider
        {
            Object.DestroyImmediate(other.GetComponent<MeshCollider>());
            return other.AddComponent<T>();
        }

        // Five walls that reach to the top but for one side.
        private void Vessel(float level)
        {
            volume.Shape = FluidVolumeShape.Vessel;
            volume.Level = level;
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            Box(new Vector3(0f, -0.175f, 0f), new Vector3(0.4f, 0.05f, 0.4f));
            Box(new Vector3(0.1f, -0.05f, 0f), new Vector3(0.04f, 0.2f, 0.24f));
            Box(new Vector3(-0.1f, -0.05f, 0f), new Vector3(0.04f, 0.2f, 0.24f));
            Box(new Vector3(0f, -0.05f, 0.1f), new Vector3(0.24f, 0.2f, 0.04f));
            Box(new Vector3(0f, -0.05f, -0.1f), new Vector3(0.24f, 0.2f, 0.04f));
        }

        private static Mesh Small(Mesh mesh)
        {
            mesh.vertices = mesh.vertices.Select(v => 0.2f * v).ToArray();
            return mesh;
        }

        private static Mesh Open()
        {
            Mesh mesh = Small(TestMeshes.Cube());
            mesh.triangles = mesh.triangles.Skip(3).ToArray();
            return mesh;
        }
    }
}
