using System;
using System.Linq;
using SphFluid.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// A new user's first minute, by the code that the menus call: a new scene with a floor, GameObject > Fluid > Tank, saved as a scene that can be played.
    /// Run it by -executeMethod SphFluid.Validation.Editor.NewUserWalk.Write, with --scene PATH below the project (Assets/NewUser.unity).
    /// </summary>
    public static class NewUserWalk
    {
        const string DefaultPath = "Assets/NewUser.unity";

        /// <summary>Writes the scene; ends with exit code 1 where the set-up has a message.</summary>
        public static void Write()
        {
            string[] words = Environment.GetCommandLineArgs();
            int at = Array.IndexOf(words, "--scene");
            string path = at >= 0 && at + 1 < words.Length ? words[at + 1] : DefaultPath;
            EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects);
            GameObject.CreatePrimitive(PrimitiveType.Plane);
            FluidMenu.CreateTank(new MenuCommand(null));
            FluidSimulation simulation = UnityEngine.Object.FindObjectsByType<FluidSimulation>(FindObjectsSortMode.None).Single();
            Look(Camera.main, simulation);
            foreach (FluidMessage message in simulation.Validate()) Console.Error.WriteLine(message.ToString());
            bool saved = EditorSceneManager.SaveScene(UnityEngine.SceneManagement.SceneManager.GetActiveScene(), path);
            Console.WriteLine(saved ? $"wrote {path}" : $"could not write {path}");
            EditorApplication.Exit(saved && simulation.Validate().Count == 0 ? 0 : 1);
        }

        // As a user does by Align With View.
        static void Look(Camera camera, FluidSimulation simulation)
        {
            Vector3 centre = simulation.transform.position;
            camera.transform.position = centre + new Vector3(1.1f, 0.75f, -1.9f);
            camera.transform.LookAt(centre);
        }
    }
}
