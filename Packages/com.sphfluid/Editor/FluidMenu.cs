using System;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// GameObject menu entries that make a working set-up, each one undo step. What has no parent stands where the Scene view looks, on
    /// what lies below.
    /// </summary>
    public static class FluidMenu
    {
        private const string Root = "GameObject/Fluid/";
        private const int Priority = 21; // after the liquids
        private const float TankEdge = 0.03f; // m: more than the spacing, so that the floor below is no wall that the liquid tests against

        private static readonly Vector3 CubicMetre = new Vector3(1f, 1f, 1f);
        private static readonly Vector3 TankSize = new Vector3(1.6f, 0.9f, 0.8f); // m: about 16,000 particles

        /// <summary>A glass tank with a block of water in a third of it.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Tank", false, Priority)]
        public static void CreateTank(MenuCommand command) => InOneStep("Create Fluid Tank", () => AddVolume(Tank("Fluid Tank", command)));

        /// <summary>A domain with a block of water in a third of it, drawn as a surface, and walls that are not to be seen.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Surface", false, Priority + 1)]
        public static void CreateWithSurface(MenuCommand command) => Create(command, typeof(FluidSurfaceRenderer));

        /// <summary>A domain with a block of water in a third of it, drawn as particles, and walls that are not to be seen.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Particles", false, Priority + 2)]
        public static void CreateWithParticles(MenuCommand command) => Create(command, typeof(FluidParticleRenderer));

        /// <summary>
        /// A nozzle that points down, at the top of the simulation that the object belongs to; outside of one in a glass tank of its own.
        /// </summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Emitter", false, Priority + 13)]
        public static void CreateEmitter(MenuCommand command) => InOneStep("Create Fluid Emitter", () =>
        {
            var parent = command.context as GameObject;
            FluidSimulation simulation = SimulationOf(parent);
            if (simulation == null) AddEmitter(simulation = Tank("Fluid Tank", command), simulation.gameObject);
            else AddEmitter(simulation, parent);
        });

        /// <summary>A liquid volume, child of the selected simulation.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Volume", false, Priority + 14)]
        public static void CreateVolume(MenuCommand command)
        {
            FluidSimulation simulation = SimulationOf(command.context as GameObject);
            if (simulation != null) InOneStep("Create Fluid Volume", () => AddVolume(simulation));
            else CreateShape(command, "Fluid Volume", FluidVolumeShape.Box);
        }

        /// <summary>A sphere of liquid, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Volume (Sphere)", false, Priority + 15)]
        public static void CreateSphere(MenuCommand command) => CreateShape(command, "Fluid Sphere", FluidVolumeShape.Sphere);

        /// <summary>Liquid in the hollow of the colliders round it, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Volume (Vessel)", false, Priority + 16)]
        public static void CreateVessel(MenuCommand command) => CreateShape(command, "Fluid Vessel", FluidVolumeShape.Vessel);

        /// <summary>A place where liquid leaves, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Drain", false, Priority + 17)]
        public static void CreateDrain(MenuCommand command) => CreatePart(command, "Fluid Drain", typeof(FluidDrain));

        /// <summary>A zone in which liquid is pushed or dragged, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Force Zone", false, Priority + 18)]
        public static void CreateForceZone(MenuCommand command) => CreatePart(command, "Fluid Force Zone", typeof(FluidForceZone));

        /// <summary>A place where the liquid is read, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Sensor", false, Priority + 19)]
        public static void CreateSensor(MenuCommand command) => CreatePart(command, "Fluid Sensor", typeof(FluidSensor));

        /// <summary>A place where pressure on a wall, velocity or density is read, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Probe", false, Priority + 20)]
        public static void CreateProbe(MenuCommand command) => CreatePart(command, "Fluid Probe", typeof(FluidProbe));

        /// <summary>A line on which the height of a liquid is read, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Gauge", false, Priority + 21)]
        public static void CreateGauge(MenuCommand command) => CreatePart(command, "Fluid Gauge", typeof(FluidGauge));

        /// <summary>A rectangle through which the flow of a liquid is read, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Flux", false, Priority + 22)]
        public static void CreateFlux(MenuCommand command) => CreatePart(command, "Fluid Flux", typeof(FluidFlux));

        /// <summary>Spray, foam and bubbles, on the selected simulation or the only one.</summary>
        /// <param name="command">Where the menu was opened.</param>
        [MenuItem(Root + "Whitewater", false, Priority + 23)]
        public static void CreateWhitewater(MenuCommand command) => AddTo<FluidWhitewater>(command);

        /// <summary>Whether there is a simulation for whitewater that has none.</summary>
        [MenuItem(Root + "Whitewater", true)]
        public static bool MayCreateWhitewater() => Lacks<FluidWhitewater>(Selection.activeGameObject);

        /// <summary>Diagnostics, on the selected simulation or the only one.</summary>
        /// <param name="command">Where the menu was opened.</param>
        [MenuItem(Root + "Diagnostics", false, Priority + 24)]
        public static void CreateDiagnostics(MenuCommand command) => AddTo<FluidDiagnostics>(command);

        /// <summary>Whether there is a simulation for diagnostics that has none.</summary>
        [MenuItem(Root + "Diagnostics", true)]
        public static bool MayCreateDiagnostics() => Lacks<FluidDiagnostics>(Selection.activeGameObject);

        /// <summary>Figures of all liquids in a corner of the screen.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Overlay", false, Priority + 25)]
        public static void CreateOverlay(MenuCommand command) => CreatePart(command, "Fluid Overlay", typeof(FluidOverlay));

        /// <summary>Adds liquid to a domain: a box over a third of its width, all of its depth and two thirds of its height.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>The new volume.</returns>
        internal static FluidVolume AddVolume(FluidSimulation simulation)
        {
            GameObject child = NewObject("Fluid Volume", simulation.gameObject, typeof(FluidVolume));
            var volume = child.GetComponent<FluidVolume>();
            Vector3 domain = simulation.DomainSize;
            volume.Size = new Vector3(domain.x / 3f, domain.y * 2f / 3f, domain.z);
            child.transform.localPosition = new Vector3((volume.Size.x - domain.x) * 0.5f, (volume.Size.y - domain.y) * 0.5f, 0f);
            Selection.activeGameObject = child;
            return volume;
        }

        /// <summary>A domain of a cubic metre without liquid, drawn as a surface.</summary>
        internal static FluidSimulation EmptyDomain(string name, MenuCommand command) =>
            Simulation(name, command, typeof(FluidSurfaceRenderer), CubicMetre, 0f);

        // Below the top by two spacings, as layers of particles leave it along its axis.
        private static void AddEmitter(FluidSimulation simulation, GameObject parent)
        {
            GameObject child = NewObject("Fluid Emitter", parent, typeof(FluidEmitter));
            Transform domain = simulation.transform;
            float drop = Mathf.Min(2f * simulation.Spacing, 0.5f * simulation.DomainSize.y);
            child.transform.SetPositionAndRotation(
                simulation.LocalToWorld.MultiplyPoint3x4(new Vector3(0f, 0.5f * simulation.DomainSize.y - drop, 0f)),
                domain.rotation * Quaternion.LookRotation(Vector3.down, Vector3.forward));
            Selection.activeGameObject = child;
        }

        private static FluidSimulation Tank(string name, MenuCommand command)
        {
            FluidSimulation simulation = Simulation(name, command, typeof(FluidSurfaceRenderer), TankSize, TankEdge);
            GameObject glass = NewObject("Glass", simulation.gameObject, typeof(MeshFilter), typeof(MeshRenderer), typeof(FluidTank));
            glass.GetComponent<FluidTank>().Edge = TankEdge;
            glass.GetComponent<MeshRenderer>().sharedMaterials = new[] { PackageAssets.TankGlass, PackageAssets.TankFrame };
            return simulation;
        }

        private static void Create(MenuCommand command, Type renderer) => InOneStep("Create Fluid", () =>
        {
            FluidSimulation simulation = Simulation("Fluid", command, renderer, CubicMetre, 0f);
            AddVolume(simulation);
            Selection.activeGameObject = simulation.gameObject;
        });

        private static FluidSimulation Simulation(string name, MenuCommand command, Type renderer, Vector3 size, float margin)
        {
            var parent = command.context as GameObject;
            GameObject root = NewObject(name, parent, typeof(FluidSimulation), renderer);
            var simulation = root.GetComponent<FluidSimulation>();
            simulation.Liquid = PackageAssets.Liquid("Water");
            simulation.DomainSize = size;
            if (FluidFix.ScaleForOne(root.transform) is Vector3 scale) root.transform.localScale = scale;
            FluidPlacement.Stand(root.transform, PlaceFor(command), size, margin);
            Selection.activeGameObject = root;
            return simulation;
        }

        private static void CreateShape(MenuCommand command, string name, FluidVolumeShape shape) => InOneStep("Create " + name, () =>
        {
            GameObject created = NewObject(name, command.context as GameObject, typeof(FluidVolume));
            var volume = created.GetComponent<FluidVolume>();
            volume.Shape = shape;
            if (command.context == null)
            {
                FluidPlacement.Stand(created.transform, FluidPlacement.Pivot, FluidGizmos.HasSize(shape) ? volume.Size : Vector3.zero);
            }
            Selection.activeGameObject = created;
        });

        private static void CreatePart(MenuCommand command, string name, Type component) => InOneStep("Create " + name, () =>
        {
            GameObject created = NewObject(name, command.context as GameObject, component);
            if (command.context == null) created.transform.position = FluidPlacement.Pivot;
            Selection.activeGameObject = created;
        });

        private static void AddTo<T>(MenuCommand command) where T : Component => InOneStep("Add " + typeof(T).Name, () =>
        {
            var selected = command.context as GameObject;
            if (!Lacks<T>(selected)) return; // the menu entry is disabled
            GameObject simulation = SimulationFor(selected).gameObject;
            Undo.AddComponent<T>(simulation);
            Selection.activeGameObject = simulation;
        });

        private static bool Lacks<T>(GameObject selected) where T : Component =>
            SimulationFor(selected) is FluidSimulation simulation && simulation != null && !simulation.TryGetComponent(out T _);

        private static FluidSimulation SimulationFor(GameObject selected)
        {
            FluidSimulation chosen = SimulationOf(selected);
            if (chosen != null) return chosen;
            FluidSimulation[] all = SceneObjects.All<FluidSimulation>();
            return all.Length == 1 ? all[0] : null;
        }

        private static FluidSimulation SimulationOf(GameObject parent) => parent != null
            ? parent.GetComponentInParent<FluidSimulation>() : null;

        /// <summary>Makes objects in one step of undo.</summary>
        internal static void InOneStep(string name, Action make)
        {
            Undo.IncrementCurrentGroup();
            int group = Undo.GetCurrentGroup();
            make();
            Undo.SetCurrentGroupName(name);
            Undo.CollapseUndoOperations(group);
        }

        private static GameObject NewObject(string name, GameObject parent, params Type[] components)
        {
            GameObject created = ObjectFactory.CreateGameObject(name, components); // registers the undo itself
            Adopt(created, parent);
            return created;
        }

        /// <summary>Puts a new object below a parent, or without one into the scene or prefab that is edited.</summary>
        internal static void Adopt(GameObject created, GameObject parent)
        {
            if (parent != null) GameObjectUtility.SetParentAndAlign(created, parent);
            else StageUtility.PlaceGameObjectInCurrentStage(created);
            GameObjectUtility.EnsureUniqueNameForSibling(created);
        }

        /// <summary>Where what a menu makes is to stand: at its parent, else where the Scene view looks.</summary>
        internal static Vector3 PlaceFor(MenuCommand command) => command.context is GameObject parent && parent != null
            ? parent.transform.position : FluidPlacement.Pivot;
    }
}
