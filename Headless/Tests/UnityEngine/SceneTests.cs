using System.Collections.Generic;
using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public class SceneTests : EngineFixture
{
    [Test]
    public void LoadSceneActsInTheNextFrameAndKeepsDontDestroyOnLoad()
    {
        var loader = EngineHooks.LoadScene;
        EngineHooks.LoadScene = (name, scene) =>
        {
            GameObject made = ObjectFactory.CreateGameObject("Loaded", scene);
            ObjectFactory.AddComponent(made, typeof(QuietProbe));
            return name == "Next";
        };
        SceneManager.sceneLoaded += OnLoaded;
        try
        {
            var kept = new GameObject("Kept");
            var lost = new GameObject("Lost");
            Object.DontDestroyOnLoad(kept);
            SceneManager.LoadScene("Next");
            Assert.That(lost != null, Is.True);
            Frame();
            Assert.That(lost == null, Is.True);
            Assert.That(kept != null, Is.True);
            Assert.That(kept.scene.name, Is.EqualTo("DontDestroyOnLoad"));
            Assert.That(SceneManager.GetActiveScene().name, Is.EqualTo("Next"));
            Assert.That(Take(), Is.EqualTo("Loaded.Awake Loaded.OnEnable loaded:Next:Single Loaded.Start"));
            Assert.That(SceneManager.GetActiveScene().GetRootGameObjects(), Has.Length.EqualTo(1));
        }
        finally
        {
            SceneManager.sceneLoaded -= OnLoaded;
            EngineHooks.LoadScene = loader;
        }
    }

    static void OnLoaded(Scene scene, LoadSceneMode mode) => Calls.Add($"loaded:{scene.name}:{mode}");

    [Test]
    public void AMissingSceneIsAnErrorThatNamesIt()
    {
        SceneManager.LoadScene("Nowhere");
        Frame();
        Assert.That(Console, Has.Some.Contains("'Nowhere'"));
    }

    [Test]
    public void PrefabAssetsNeverRunAndAreProtected()
    {
        GameObject prefab = ObjectFactory.CreateGameObject("Prefab", null);
        ObjectFactory.AddComponent(prefab, typeof(QuietProbe));
        Frame();
        Assert.That(Take(), Is.Empty);
        Assert.That(prefab.scene.IsValid(), Is.False);
        Assert.That(Object.FindFirstObjectByType<QuietProbe>() == null, Is.True);
        Object.DestroyImmediate(prefab);
        Assert.That(prefab != null, Is.True);
        Assert.That(Console, Has.Some.Contains("Destroying assets is not permitted"));
        GameObject instance = Object.Instantiate(prefab);
        Assert.That(Take(), Is.EqualTo("Prefab(Clone).Awake Prefab(Clone).OnEnable"));
        Assert.That(instance.scene.IsValid(), Is.True);
        Object.DestroyImmediate(prefab, true);
    }

    [Test]
    public void RuntimeInitializeMethodsRunAroundTheFirstScene()
    {
        PlaySession.End();
        InitializeSample.Calls.Clear();
        PlaySession.Begin(null, typeof(InitializeSample).Assembly);
        Assert.That(InitializeSample.Calls, Is.EqualTo(new[] { "subsystem", "assemblies", "splash", "before", "after" }));
    }
}
