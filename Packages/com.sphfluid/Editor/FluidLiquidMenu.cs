using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// GameObject menu entries for the package's liquids: each puts the liquid's prefab into the scene, in one undo step.
    /// </summary>
    internal static class FluidLiquidMenu
    {
        private const string Root = "GameObject/Fluid/Liquid/";
        private const int Priority = 11;

        [MenuItem(Root + "Water", false, Priority)]
        private static void CreateWater(MenuCommand command) => Create("Water", command);

        [MenuItem(Root + "Sea Water", false, Priority + 1)]
        private static void CreateSeaWater(MenuCommand command) => Create("Sea Water", command);

        [MenuItem(Root + "Muddy River", false, Priority + 2)]
        private static void CreateMuddyRiver(MenuCommand command) => Create("Muddy River", command);

        [MenuItem(Root + "Honey", false, Priority + 3)]
        private static void CreateHoney(MenuCommand command) => Create("Honey", command);

        [MenuItem(Root + "Oil", false, Priority + 4)]
        private static void CreateOil(MenuCommand command) => Create("Oil", command);

        [MenuItem(Root + "Milk", false, Priority + 5)]
        private static void CreateMilk(MenuCommand command) => Create("Milk", command);

        [MenuItem(Root + "Blood", false, Priority + 6)]
        private static void CreateBlood(MenuCommand command) => Create("Blood", command);

        [MenuItem(Root + "Lava", false, Priority + 7)]
        private static void CreateLava(MenuCommand command) => Create("Lava", command);

        [MenuItem(Root + "Mercury", false, Priority + 8)]
        private static void CreateMercury(MenuCommand command) => Create("Mercury", command);

        [MenuItem(Root + "Slime", false, Priority + 9)]
        private static void CreateSlime(MenuCommand command) => Create("Slime", command);

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
