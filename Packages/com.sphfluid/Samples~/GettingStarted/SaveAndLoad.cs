using System.IO;
using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Saves a liquid to a file and brings it back, also in another run of the game. Call Save and Load from a menu of the game, or choose
    /// them in the menu of this component.
    /// </summary>
    public sealed class SaveAndLoad : MonoBehaviour
    {
        [SerializeField] private FluidSimulation tank;

        [SerializeField, Tooltip("Name of the file in Application.persistentDataPath.")]
        private string file = "tank.fluid";

        private string FilePath => Path.Combine(Application.persistentDataPath, file);

        /// <summary>Writes the liquid as it is now. What a game has besides, such as its crates, it saves itself.</summary>
        [ContextMenu("Save")]
        public void Save()
        {
            using (FileStream stream = File.Create(FilePath)) tank.Save(stream);
        }

        /// <summary>Puts what was saved in the place of the liquid, if there is such a file.</summary>
        [ContextMenu("Load")]
        public void Load()
        {
            if (!File.Exists(FilePath)) return;
            using (FileStream stream = File.OpenRead(FilePath)) tank.Restore(stream);
        }
    }
}
