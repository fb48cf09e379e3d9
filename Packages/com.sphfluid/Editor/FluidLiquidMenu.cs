using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>GameObject menu entries for the package's liquids: each puts the liquid's prefab into the scene, in one undo step.</summary>
    public static class FluidLiquidMenu
    {
        private const string Root = "GameObject/Fluid/Liquid/";
        private const int Priority = 11;

        /// <summary>A glass tank in which a block of water falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Water", false, Priority)]
        public static void CreateWater(MenuCommand command) => Create("Water", command);

        /// <summary>A glass tank in which a block of sea water falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Sea Water", false, Priority + 1)]
        public static void CreateSeaWater(MenuCommand command) => Create("Sea Water", command);

        /// <summary>A glass tank in which a block of a muddy river's water falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Muddy River", false, Priority + 2)]
        public static void CreateMuddyRiver(MenuCommand command) => Create("Muddy River", command);

        /// <summary>Honey that is poured into a small glass tank.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Honey", false, Priority + 3)]
        public static void CreateHoney(MenuCommand command) => Create("Honey", command);

        /// <summary>Olive oil that is poured into a small glass tank.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Oil", false, Priority + 4)]
        public static void CreateOil(MenuCommand command) => Create("Oil", command);

        /// <summary>A small glass tank in which a block of milk falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Milk", false, Priority + 5)]
        public static void CreateMilk(MenuCommand command) => Create("Milk", command);

        /// <summary>A small glass tank in which a block of blood falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Blood", false, Priority + 6)]
        public static void CreateBlood(MenuCommand command) => Create("Blood", command);

        /// <summary>Lava that is poured into a glass tank.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Lava", false, Priority + 7)]
        public static void CreateLava(MenuCommand command) => Create("Lava", command);

        /// <summary>A small glass tank in which a block of mercury falls.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Mercury", false, Priority + 8)]
        public static void CreateMercury(MenuCommand command) => Create("Mercury", command);

        /// <summary>Slime that is poured into a small glass tank.</summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Root + "Slime", false, Priority + 9)]
        public static void CreateSlime(MenuCommand command) => Create("Slime", command);

        private static void Create(string liquid, MenuCommand command) => FluidMenu.InOneStep("Create " + liquid, () =>
        {
            GameObject root = Object.Instantiate(PackageAssets.Prefab(liquid));
            root.name = liquid;
            Undo.RegisterCreatedObjectUndo(root, "Create " + liquid);
            FluidMenu.Adopt(root, command.context as GameObject);
            if (FluidFix.ScaleForOne(root.transform) is Vector3 scale) root.transform.localScale = scale;
            var simulation = root.GetComponentInChildren<FluidSimulation>();
            Transform domain = simulation.transform;
            Vector3 before = domain.position;
            FluidPlacement.Stand(domain, FluidMenu.PlaceFor(command), simulation.DomainSize, domain.localPosition.y -
                0.5f * simulation.DomainSize.y);
            Vector3 moved = domain.position - before;
            domain.position = before;
            root.transform.position += moved;
            Selection.activeGameObject = simulation.gameObject;
        });
    }
}
