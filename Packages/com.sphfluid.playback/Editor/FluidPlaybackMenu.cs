using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>The GameObject menu's entry for a liquid that is played back.</summary>
    public static class FluidPlaybackMenu
    {
        private const string Path = "GameObject/Fluid/Playback";
        private const int AfterParticles = 24;

        /// <summary>
        /// A domain without liquid of its own, drawn as a surface, whose Fluid Playback plays a sequence once it has a folder.
        /// </summary>
        /// <param name="command">Where the menu was opened; its object becomes the parent.</param>
        [MenuItem(Path, false, AfterParticles)]
        public static void CreatePlayback(MenuCommand command) => FluidMenu.InOneStep("Create Fluid Playback", () =>
            ObjectFactory.AddComponent<FluidPlayback>(FluidMenu.EmptyDomain("Fluid Playback", command).gameObject));
    }
}
