using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>GameObject menu entries that make a working set-up, each one undo step.</summary>
    public static class FluidMenu
    {
        const string Root = "GameObject/Fluid/";
        const int Priority = 11;

        /// <summary>A tank of water: domain, liquid in a third of it, drawn as particles.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Simulation (Particles)", false, Priority)]
        public static void CreateWithParticles(MenuCommand command) => Create(command, typeof(FluidParticleRenderer));

        /// <summary>A tank of water: domain, liquid in a third of it, drawn as a surface.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Simulation (Surface)", false, Priority + 1)]
        public static void CreateWithSurface(MenuCommand command) => Create(command, typeof(FluidSurfaceRenderer));

        /// <summary>A liquid volume, child of the selected simulation.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Volume", false, Priority + 2)]
        public static void CreateVolume(MenuCommand command)
        {
            var parent = command.context as GameObject;
            FluidSimulation simulation = parent != null ? parent.GetComponentInParent<FluidSimulation>() : null;
            if (simulation != null) AddVolume(simulation);
            else Finish(NewObject("Fluid Volume", parent, typeof(FluidVolume)));
        }

        /// <summary>A sphere of liquid, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Volume (Sphere)", false, Priority + 3)]
        public static void CreateSphere(MenuCommand command) => CreateShape(command, "Fluid Sphere", FluidVolumeShape.Sphere);

        /// <summary>Liquid in the hollow of the colliders round it, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Volume (Vessel)", false, Priority + 4)]
        public static void CreateVessel(MenuCommand command) => CreateShape(command, "Fluid Vessel", FluidVolumeShape.Vessel);

        /// <summary>A nozzle that points down, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Emitter", false, Priority + 5)]
        public static void CreateEmitter(MenuCommand command)
        {
            GameObject created = NewObject("Fluid Emitter", command.context as GameObject, typeof(FluidEmitter));
            created.transform.localRotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            Finish(created);
        }

        /// <summary>A place where liquid leaves, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Drain", false, Priority + 6)]
        public static void CreateDrain(MenuCommand command) => Finish(NewObject("Fluid Drain", command.context as GameObject, typeof(FluidDrain)));

        /// <summary>A zone in which liquid is pushed or dragged, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Force Zone", false, Priority + 7)]
        public static void CreateForceZone(MenuCommand command) => Finish(NewObject("Fluid Force Zone", command.context as GameObject, typeof(FluidForceZone)));

        /// <summary>A place where the liquid is read, child of the selected object.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Fluid Sensor", false, Priority + 8)]
        public static void CreateSensor(MenuCommand command) => Finish(NewObject("Fluid Sensor", command.context as GameObject, typeof(FluidSensor)));

        static void CreateShape(MenuCommand command, string name, FluidVolumeShape shape)
        {
            GameObject created = NewObject(name, command.context as GameObject, typeof(FluidVolume));
            created.GetComponent<FluidVolume>().Shape = shape;
            Finish(created);
        }

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
            Finish(child);
            return volume;
        }

        static void Create(MenuCommand command, System.Type renderer)
        {
            int group = Undo.GetCurrentGroup();
            GameObject root = NewObject("Fluid", command.context as GameObject, typeof(FluidSimulation), renderer);
            var simulation = root.GetComponent<FluidSimulation>();
            simulation.Profile = PackageAssets.Water;
            AddVolume(simulation);
            Finish(root);
            Undo.CollapseUndoOperations(group);
        }

        static GameObject NewObject(string name, GameObject parent, params System.Type[] components)
        {
            GameObject created = ObjectFactory.CreateGameObject(name, components); // registers the undo itself
            if (parent != null) GameObjectUtility.SetParentAndAlign(created, parent);
            else StageUtility.PlaceGameObjectInCurrentStage(created);
            GameObjectUtility.EnsureUniqueNameForSibling(created);
            Undo.SetCurrentGroupName("Create " + name);
            return created;
        }

        static void Finish(GameObject created) => Selection.activeGameObject = created;
    }
}
