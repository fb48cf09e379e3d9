using System.Linq;
using System.Reflection;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Tests
{
    /// <summary>Menu entries: what they make works, stands on what lies below, and goes in one step of undo.</summary>
    public sealed class FluidMenuTests
    {
        private const BindingFlags Statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

        private static readonly MenuCommand Nowhere = new MenuCommand(null);

        private static readonly System.Action<MenuCommand>[] Entries =
        {
            FluidMenu.CreateTank, FluidMenu.CreateWithSurface, FluidMenu.CreateWithParticles, FluidMenu.CreateEmitter,
            FluidMenu.CreateVolume,
            FluidMenu.CreateSphere, FluidMenu.CreateVessel, FluidMenu.CreateDrain, FluidMenu.CreateForceZone, FluidMenu.CreateSensor,
            FluidMenu.CreateProbe, FluidMenu.CreateGauge, FluidMenu.CreateFlux, FluidMenu.CreateOverlay,
        };

        [SetUp]
        public void SetUp() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);

        [TearDown]
        public void TearDown() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);

        [Test]
        public void EachEntryIsUndoneInOneStep([ValueSource(nameof(Entries))] System.Action<MenuCommand> entry)
        {
            var kept = new GameObject("Kept");
            Undo.IncrementCurrentGroup();
            entry(Nowhere);
            Assert.That(Roots(), Has.Length.EqualTo(2));
            Undo.PerformUndo();
            Assert.That(Roots(), Is.EqualTo(new[] { kept }));
        }

        [Test]
        public void LiquidsComeFirstThenTheTankAndNoneRepeatsTheWordFluid()
        {
            MenuItem[] entries = new[] { typeof(FluidMenu), typeof(FluidLiquidMenu) }.SelectMany(t => t.GetMethods(Statics))
                .SelectMany(m => m.GetCustomAttributes(typeof(MenuItem), false)).Cast<MenuItem>()
                .Where(e => !e.validate).OrderBy(e => e.priority).ToArray();
            Assert.That(entries.Last().priority, Is.LessThan(50), "entries beyond are not in the Hierarchy's menu");
            string[] paths = entries.Select(e => e.menuItem).ToArray();
            Assert.That(paths[0], Is.EqualTo("GameObject/Fluid/Liquid/Water"));
            Assert.That(paths.First(e => !e.Contains("/Liquid/")), Is.EqualTo("GameObject/Fluid/Tank"));
            Assert.That(paths,
                Is.SupersetOf(new[] { "GameObject/Fluid/Surface", "GameObject/Fluid/Particles", "GameObject/Fluid/Emitter" }));
            Assert.That(paths.Select(e => e.Substring("GameObject/Fluid/".Length)), Has.None.Contains("Fluid"));
        }

        [Test]
        public void TheTankHasGlassAFrameWaterAndASurface()
        {
            FluidMenu.CreateTank(Nowhere);
            FluidSimulation simulation = Only<FluidSimulation>();
            Assert.That(simulation.Liquid.name, Is.EqualTo("Water"));
            Assert.That(simulation.OwnProfile, Is.Null);
            Assert.That(simulation.GetComponent<FluidSurfaceRenderer>().Look, Is.EqualTo(FluidSurfaceLook.Water));
            Assert.That(Only<FluidVolume>().transform.parent, Is.EqualTo(simulation.transform));
            var glass = Only<FluidTank>();
            Assert.That(glass.Simulation, Is.EqualTo(simulation));
            Assert.That(glass.GetComponent<MeshRenderer>().sharedMaterials.Select(m => m.shader.name),
                Is.EqualTo(new[] { "SPH Fluid/Glass", "SPH Fluid/Scenery" }));
            Bounds bounds = glass.GetComponent<MeshFilter>().sharedMesh.bounds;
            Assert.That(Vector3.Distance(bounds.size, simulation.DomainSize + 2f * glass.Edge * Vector3.one), Is.LessThan(1e-5f));
            Assert.That(simulation.Validate()
                .Concat(ViewRules.Check(simulation) is FluidMessage unseen ? new[] { unseen } : new FluidMessage[0])
                .Select(m => m.ToString()), Is.Empty);
        }

        [Test]
        public void OnAFloorTheWholeTankStandsOnItAndTheLiquidKnowsNothingOfIt()
        {
            Plane(new Vector3(0f, 0f, 0f));
            FluidMenu.CreateTank(Nowhere);
            FluidSimulation simulation = Only<FluidSimulation>();
            float edge = Only<FluidTank>().Edge;
            Assert.That(Bottom(simulation), Is.EqualTo(edge).Within(1e-5));
            Assert.That(Only<MeshRenderer>("Glass").bounds.min.y, Is.EqualTo(0f).Within(1e-5));
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
            using (var collision = new CollisionScene())
            {
                collision.Gather(simulation.Spec.Query());
                Assert.That(collision.Solids, Is.Empty);
            }
        }

        [Test]
        public void WithoutAFloorItStandsOnTheGround([Values(0, 1)] int entry)
        {
            Entries[entry](Nowhere);
            Assert.That(Bottom(Only<FluidSimulation>()), Is.EqualTo(entry == 0 ? Only<FluidTank>().Edge : 0f).Within(1e-5));
        }

        [Test]
        public void ItStandsOnTheHighestSurfaceInItsOutline()
        {
            Plane(new Vector3(0f, -2f, 0f));
            GameObject step = GameObject.CreatePrimitive(PrimitiveType.Cube); // its top is at -0.5; only a corner is over it
            step.transform.position = new Vector3(0.9f, -1f, 0.9f);
            FluidMenu.CreateWithSurface(Nowhere);
            Assert.That(Bottom(Only<FluidSimulation>()), Is.EqualTo(-0.5f).Within(1e-4));
        }

        [Test]
        public void ACeilingAboveIsNoFloor()
        {
            Plane(Vector3.zero);
            GameObject ceiling = GameObject.CreatePrimitive(PrimitiveType.Cube);
            ceiling.transform.position = new Vector3(0f, 2.5f, 0f);
            FluidMenu.CreateWithParticles(Nowhere);
            Assert.That(Bottom(Only<FluidSimulation>()), Is.EqualTo(0f).Within(1e-5));
        }

        [Test]
        public void InsideASolidItStandsOnTop()
        {
            GameObject block = GameObject.CreatePrimitive(PrimitiveType.Cube);
            block.transform.localScale = 5f * Vector3.one;
            FluidMenu.CreateWithSurface(Nowhere);
            Assert.That(Bottom(Only<FluidSimulation>()), Is.EqualTo(2.5f).Within(1e-3));
        }

        [Test]
        public void BelowAParentItStandsUnderIt()
        {
            Plane(new Vector3(3f, 1f, 4f));
            var parent = new GameObject("Room");
            parent.transform.position = new Vector3(3f, 1.2f, 4f);
            parent.transform.localScale = 2f * Vector3.one;
            FluidMenu.CreateTank(new MenuCommand(parent));
            FluidSimulation simulation = Only<FluidSimulation>();
            Assert.That(simulation.transform.parent, Is.EqualTo(parent.transform));
            Assert.That(simulation.transform.lossyScale, Is.EqualTo(Vector3.one));
            Assert.That(simulation.transform.position.x, Is.EqualTo(3f).Within(1e-5));
            Assert.That(Bottom(simulation), Is.EqualTo(1f + Only<FluidTank>().Edge).Within(1e-5));
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
        }

        [Test]
        public void AnEmitterOutsideASimulationHasATankOfItsOwn()
        {
            Plane(Vector3.zero);
            FluidMenu.CreateEmitter(Nowhere);
            FluidSimulation simulation = Only<FluidSimulation>();
            CheckEmitter(simulation);
            Assert.That(Bottom(simulation), Is.GreaterThanOrEqualTo(0f));
            Assert.That(SceneObjects.All<FluidVolume>(), Is.Empty);
        }

        [Test]
        public void AnEmitterInASimulationIsAtItsTop()
        {
            FluidMenu.CreateWithSurface(Nowhere);
            FluidSimulation simulation = Only<FluidSimulation>();
            simulation.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 30f, 20f));
            FluidMenu.CreateEmitter(new MenuCommand(simulation.GetComponentInChildren<FluidVolume>().gameObject));
            CheckEmitter(simulation);
        }

        [Test]
        public void WhitewaterAndDiagnosticsComeToTheOnlySimulationOrTheSelectedOne()
        {
            Assert.That(FluidMenu.MayCreateWhitewater(), Is.False);
            FluidMenu.CreateWithSurface(Nowhere);
            FluidSimulation first = Only<FluidSimulation>();
            Selection.activeGameObject = null;
            Assert.That(FluidMenu.MayCreateWhitewater(), Is.True);
            FluidMenu.CreateWhitewater(Nowhere);
            Assert.That(Only<FluidWhitewater>().gameObject, Is.EqualTo(first.gameObject));
            Assert.That(FluidMenu.MayCreateWhitewater(), Is.False);
            FluidMenu.CreateWithSurface(Nowhere);
            Selection.activeGameObject = null;
            Assert.That(FluidMenu.MayCreateDiagnostics(), Is.False, "of two none is meant");
            FluidMenu.CreateDiagnostics(new MenuCommand(first.GetComponentInChildren<FluidVolume>().gameObject));
            Assert.That(Only<FluidDiagnostics>().gameObject, Is.EqualTo(first.gameObject));
            Undo.PerformUndo();
            Assert.That(SceneObjects.All<FluidDiagnostics>(), Is.Empty);
        }

        [Test]
        public void VolumesStandOnTheFloorOrBelongToTheSimulation()
        {
            Plane(Vector3.zero);
            FluidMenu.CreateSphere(Nowhere);
            var sphere = Only<FluidVolume>();
            Assert.That(sphere.Shape, Is.EqualTo(FluidVolumeShape.Sphere));
            Assert.That(sphere.transform.position.y, Is.EqualTo(0.5f * sphere.Size.y).Within(1e-5));
            Object.DestroyImmediate(sphere.gameObject);
            FluidMenu.CreateEmitter(Nowhere);
            FluidSimulation simulation = Only<FluidSimulation>();
            FluidMenu.CreateVolume(new MenuCommand(simulation.gameObject));
            Assert.That(Only<FluidVolume>().transform.parent, Is.EqualTo(simulation.transform));
        }

        private static void CheckEmitter(FluidSimulation simulation)
        {
            FluidEmitter emitter = Only<FluidEmitter>();
            Assert.That(emitter.transform.IsChildOf(simulation.transform));
            Matrix4x4 toDomain = simulation.LocalToWorld.inverse;
            Vector3 place = toDomain.MultiplyPoint3x4(emitter.transform.position);
            Assert.That(place.y,
                Is.InRange(0.5f * simulation.DomainSize.y - 3f * simulation.Spacing, 0.5f * simulation.DomainSize.y - simulation.Spacing));
            Assert.That(Vector3.Distance(toDomain.MultiplyVector(emitter.transform.forward), Vector3.down), Is.LessThan(1e-5f));
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
        }

        private static GameObject[] Roots() => SceneManager.GetActiveScene().GetRootGameObjects();

        private static T Only<T>(string name = null) where T : Component =>
            SceneObjects.All<T>().Single(c => name == null || c.name == name);

        private static float Bottom(FluidSimulation simulation) => simulation.transform.position.y - 0.5f * simulation.DomainSize.y;

        private static void Plane(Vector3 position) => GameObject.CreatePrimitive(PrimitiveType.Plane).transform.position = position;
    }
}
