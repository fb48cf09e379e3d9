using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Every kind of collider on a Rigidbody, made unfit in every way that it can be, alone or beside one that serves: the liquid goes on,
    /// and each is named once with a cure.
    /// </summary>
    public sealed class SkippedColliderTests
    {
        private static readonly string[] MeshFaults = { "no mesh", "no vertices", "no triangles", "lines", "not readable", "no area",
            "no numbers" };

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private readonly List<Object> made = new List<Object>();
        private readonly List<string> faults = new List<string>();
        private SimulationRig rig;
        private FluidSimulation simulation;
        private string current;
        private int updates;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            Time.fixedDeltaTime = 100f; // bodies stay where they are
            simulation = rig.Create();
            simulation.Updated += s => updates++;
            LogAssert.ignoreFailingMessages = true; // counted by case
            Application.logMessageReceived += Note;
        }

        [TearDown]
        public void TearDown()
        {
            Time.fixedDeltaTime = fixedDelta;
            Application.logMessageReceived -= Note;
            LogAssert.ignoreFailingMessages = false;
            rig.Dispose();
            foreach (Object item in made) Object.DestroyImmediate(item);
        }

        private static IEnumerable<(string Name, Func<SkippedColliderTests, GameObject, Component> Add)> Cases()
        {
            yield return ("box, no size", (t, o) => t.Box(o, new Vector3(0.1f, 0f, 0.1f)));
            yield return ("box, size no number", (t, o) => t.Box(o, new Vector3(0.1f, float.NaN, 0.1f)));
            yield return ("box, no scale", (t, o) => t.Box(Scaled(o, new Vector3(0f, 1f, 1f)), 0.1f * Vector3.one));
            yield return ("box, no scale at all", (t, o) => t.Box(Scaled(o, Vector3.zero), 0.1f * Vector3.one));
            yield return ("sphere, no radius", (t, o) => t.Sphere(o, 0f));
            yield return ("sphere, radius no number", (t, o) => t.Sphere(o, float.NaN));
            yield return ("sphere, no scale", (t, o) => t.Sphere(Scaled(o, new Vector3(0f, 1f, 1f)), 0.05f));
            yield return ("capsule, no radius", (t, o) => t.Capsule(o, 0f));
            yield return ("capsule, radius no number", (t, o) => t.Capsule(o, float.NaN));
            yield return ("capsule, no scale", (t, o) => t.Capsule(Scaled(o, new Vector3(1f, 0f, 1f)), 0.05f));
            yield return ("character, no radius", (t, o) => t.Character(o, 0f));
            yield return ("character, no scale", (t, o) => t.Character(Scaled(o, Vector3.zero), 0.05f));
            yield return ("wheel, no radius", (t, o) => t.Wheel(o, 0f));
            yield return ("wheel, no scale", (t, o) => t.Wheel(Scaled(o, new Vector3(1f, 0f, 1f)), 0.05f));
            yield return ("terrain, no data", (t, o) => o.AddComponent<TerrainCollider>());
            yield return ("terrain, no size", (t, o) => t.Terrain(o, 33, Vector3.zero));
            yield return ("terrain, too many cells", (t, o) => t.Terrain(o, 2049, new Vector3(0.3f, 0.1f, 0.3f)));
            foreach (bool convex in new[] { false, true })
            {
                string kind = convex ? "convex mesh, " : "mesh, ";
                foreach (string fault in MeshFaults) yield return (kind + fault, (t, o) => t.MeshOf(o, convex, t.Faulty(fault)));
                yield return (kind + "no scale", (t, o) => t.MeshOf(Scaled(o, new Vector3(1f, 1f, 0f)), convex, t.Faulty("none")));
            }
            foreach (string fault in MeshFaults.Skip(1).Append("too many vertices"))
            {
                yield return ("skin, " + fault, (t, o) => t.Skin(o, t.Faulty(fault)));
            }
            yield return ("skin, no scale", (t, o) => t.Skin(Scaled(o, Vector3.zero), t.Faulty("none")));
        }

        [UnityTest]
        public IEnumerator TheLiquidGoesOnAndEachIsNamedOnce([Values] bool beside)
        {
            while (!simulation.IsRunning) yield return null;
            foreach ((string name, Func<SkippedColliderTests, GameObject, Component> add) in Cases())
            {
                current = name;
                GameObject body = rig.NewObject("Body");
                Rigidbody rigidbody = body.AddComponent<Rigidbody>();
                rigidbody.useGravity = false;
                (rigidbody.centerOfMass, rigidbody.inertiaTensor) = (Vector3.zero, Vector3.one); // not by shapes that have none
                GameObject part = rig.NewObject("Part");
                part.transform.SetParent(body.transform, false);
                Component unfit = add(this, part);
                if (beside) Box(rig.NewObject("Healthy"), 0.1f * Vector3.one).transform.SetParent(body.transform, false);
                updates = 0;
                yield return null;
                yield return null;
                if (updates != 2) Fail($"{updates} of 2 frames were finished");
                if (beside && simulation.Solver.State.Bodies.Floating.Count != 1)
                {
                    Fail("the liquid does not move the body by the collider that serves");
                }
                List<FluidMessage> found = simulation.Messages.Where(m => m.Context == unfit).ToList();
                if (found.Count == 0 && unfit is MeshCollider) found = simulation.Validate().Where(m => m.Context == unfit).ToList();
                bool isThere = !(unfit is Collider) || unfit is MeshCollider || unfit is WheelCollider ||
                    Physics.OverlapBox(Vector3.zero, Vector3.one).Contains(unfit);
                if (isThere ? found.Count != 1 || found[0].Severity != FluidSeverity.Warning ||
                    string.IsNullOrEmpty(found[0].Cure) : found.Count > 0)
                {
                    Fail("named: " + (found.Count == 0 ? "not" : string.Join(" / ", found.Select(m => m.ToString()))));
                }
                Object.DestroyImmediate(body);
            }
            Assert.That(faults, Is.Empty, string.Join("\n", faults));
        }

        private void Note(string text, string trace, LogType type)
        {
            if (type != LogType.Warning && type != LogType.Log) Fail(text + "\n" + trace);
        }

        private void Fail(string what) => faults.Add($"{current}: {what}");

        private static GameObject Scaled(GameObject o, Vector3 scale)
        {
            o.transform.localScale = scale;
            return o;
        }

        private BoxCollider Box(GameObject o, Vector3 size)
        {
            var box = o.AddComponent<BoxCollider>();
            box.size = size;
            return box;
        }

        private Component Sphere(GameObject o, float radius)
        {
            var sphere = o.AddComponent<SphereCollider>();
            sphere.radius = radius;
            return sphere;
        }

        private Component Capsule(GameObject o, float radius)
        {
            var capsule = o.AddComponent<CapsuleCollider>();
            (capsule.radius, capsule.height) = (radius, 0.15f);
            return capsule;
        }

        private Component Character(GameObject o, float radius)
        {
            var character = o.AddComponent<CharacterController>();
            (character.radius, character.height) = (radius, 0.15f);
            return character;
        }

        private Component Wheel(GameObject o, float radius)
        {
            o.AddComponent<FluidCollider>().WheelColliders = true;
            var wheel = o.AddComponent<WheelCollider>();
            (wheel.radius, wheel.suspensionDistance) = (radius, 0f);
            return wheel;
        }

        private Component Terrain(GameObject o, int resolution, Vector3 size)
        {
            var data = new TerrainData { heightmapResolution = resolution, size = size };
            made.Add(data);
            var terrain = o.AddComponent<TerrainCollider>();
            terrain.terrainData = data;
            return terrain;
        }

        private Component MeshOf(GameObject o, bool convex, Mesh mesh)
        {
            var collider = o.AddComponent<MeshCollider>();
            collider.convex = convex;
            collider.sharedMesh = mesh;
            return collider;
        }

        private Component Skin(GameObject o, Mesh mesh)
        {
            o.AddComponent<FluidCollider>().SkinnedMeshes = true;
            var skin = o.AddComponent<SkinnedMeshRenderer>();
            skin.sharedMesh = mesh;
            skin.localBounds = new Bounds(Vector3.zero, 0.1f * Vector3.one);
            return skin;
        }

        private Mesh Faulty(string fault)
        {
            if (fault == "no mesh") return null;
            Mesh mesh = fault == "no vertices" ? new Mesh() : TestMeshes.Cube();
            made.Add(mesh);
            Vector3[] corners = mesh.vertices;
            switch (fault)
            {
                case "no triangles": mesh.triangles = new int[0]; break;
                case "lines": mesh.SetIndices(new[] { 0, 1, 1, 2 }, MeshTopology.Lines, 0); break;
                case "no area": mesh.vertices = corners.Select(c => 0.1f * Vector3.one).ToArray(); break;
                case "no numbers": mesh.vertices = corners.Select(c => float.NaN * Vector3.one).ToArray(); break;
                case "too many vertices": mesh.vertices = corners.Concat(new Vector3[SkinnedWalls.MostVertices]).ToArray(); break;
            }
            if (fault != "no vertices") mesh.bounds = new Bounds(Vector3.zero, 0.1f * Vector3.one);
            if (fault == "not readable") mesh.UploadMeshData(true);
            return mesh;
        }
    }
}
