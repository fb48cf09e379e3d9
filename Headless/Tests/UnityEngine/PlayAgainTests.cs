using System.IO;
using System.Linq;
using Headless.CommandLine;
using Headless.Engine;
using Headless.Importers.Project;
using Headless.Player;
using Headless.Tests.Importers;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;
using ObjectFactory = Headless.Engine.ObjectFactory;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Play mode that is entered, left and entered again in one process.</summary>
public class PlayAgainTests : EngineFixture
{
    static int s_Plays;

    [Test]
    public void StaticsStayAndInitializeMethodsRunInEachPlay()
    {
        InitializeSample.Calls.Clear();
        string[] once = ["subsystem", "assemblies", "splash", "before", "after"];
        for (int play = 0; play < 2; play++)
        {
            PlaySession.End();
            PlaySession.Begin(null, typeof(InitializeSample).Assembly);
        }
        Assert.That(InitializeSample.Calls, Is.EqualTo(once.Concat(once)));
    }

    [Test]
    public void TimeAndFramesBeginAtZeroInEachPlay()
    {
        Time.fixedDeltaTime = 0.05f;
        Frame(3);
        Assert.That((Time.frameCount, Time.time), Is.EqualTo((3, 0.2f)));
        PlaySession.End();
        PlaySession.Begin(null);
        Assert.That((Time.frameCount, Time.time, Time.fixedTime, Time.timeSinceLevelLoad), Is.EqualTo((0, 0f, 0f, 0f)));
        Assert.That((Time.captureDeltaTime, Time.fixedDeltaTime), Is.EqualTo((0.1f, 0.05f)), "settings stay");
        Frame(2);
        Assert.That((Time.frameCount, Time.time), Is.EqualTo((2, 0.1f)));
    }

    [Test]
    public void TheEditorTellsOfPlayModeAndOpensTheSceneAgain()
    {
        PlaySession.End();
        EngineState.IsEditor = true;
        var before = EngineHooks.LoadScene;
        EngineHooks.LoadScene = (name, scene) =>
        {
            ObjectFactory.AddComponent(ObjectFactory.CreateGameObject(name == "Open.unity" ? "A" : "B", scene), typeof(Probe));
            return true;
        };
        EditorApplication.playModeStateChanged += Note;
        try
        {
            UnityEditor.SceneManagement.EditorSceneManager.OpenScene("Open.unity");
            Take();
            for (int play = 0; play < 2; play++)
            {
                EditorApplication.EnterPlaymode();
                SceneManager.LoadScene("Other");
                Frame();
                EditorApplication.ExitPlaymode();
                Assert.That(Take(), Is.EqualTo("ExitingEditMode A.Awake A.OnEnable EnteredPlayMode A.OnDisable A.OnDestroy B.Awake B.OnEnable B.Start B.FixedUpdate B.Update B.LateUpdate "
                    + "ExitingPlayMode B.Quit B.OnDisable B.OnDestroy EnteredEditMode"));
                Assert.That((SceneManager.GetActiveScene().path, Application.isPlaying), Is.EqualTo(("Open.unity", false)));
            }
        }
        finally
        {
            EditorApplication.playModeStateChanged -= Note;
            EngineHooks.LoadScene = before;
        }
    }

    static void Note(PlayModeStateChange change) => Calls.Add(change.ToString());

    [TestCase("", false, EnterPlayModeOptions.None, true)]
    [TestCase("m_EnterPlayModeOptionsEnabled: 0\n  m_EnterPlayModeOptions: 1", false, EnterPlayModeOptions.None, true)]
    [TestCase("m_EnterPlayModeOptionsEnabled: 1\n  m_EnterPlayModeOptions: 0", true, EnterPlayModeOptions.None, true)]
    [TestCase("m_EnterPlayModeOptionsEnabled: 1\n  m_EnterPlayModeOptions: 1", true, EnterPlayModeOptions.DisableDomainReload, false)]
    [TestCase("m_EnterPlayModeOptionsEnabled: 1\n  m_EnterPlayModeOptions: 2", true, EnterPlayModeOptions.DisableSceneReload, true)]
    [TestCase("m_EnterPlayModeOptionsEnabled: 1\n  m_EnterPlayModeOptions: 3", true, EnterPlayModeOptions.DisableDomainReload | EnterPlayModeOptions.DisableSceneReload, false)]
    public void TheProjectsSettingsSayHowPlayModeIsEntered(string settings, bool enabled, EnterPlayModeOptions options, bool reloads)
    {
        using var project = new TemporaryProject();
        if (settings.Length > 0) project.Add("ProjectSettings/EditorSettings.asset", $"%YAML 1.1\n--- !u!159 &1\nEditorSettings:\n  {settings}\n");
        ProjectSettingsReader.Apply(project.Root, line => Assert.Fail(line));
        Assert.That((EditorSettings.enterPlayModeOptionsEnabled, EditorSettings.enterPlayModeOptions, EngineState.ReloadsDomain), Is.EqualTo((enabled, options, reloads)));
        TestDelegate twice = () => EngineSession.RequireStaticsThatStay("--twice");
        if (reloads) Assert.That(twice, Throws.TypeOf<UsageException>().With.Message.Contains("Reload Scene only"));
        else Assert.That(twice, Throws.Nothing);
    }

    [Test]
    public void ASecondRunOfPlayTestsHasTheStaticsOfTheFirst()
    {
        PlaySession.End();
        s_Plays = 0;
        for (int play = 1; play <= 2; play++)
        {
            var selection = new TestSelection { Filter = nameof(RunnerSamples.SamplePasses), Within = play == 1 ? null : "Frames$" };
            TestRunResult result = UnityTestRunner.Run(new[] { typeof(PlayAgainTests).Assembly }, UnityEngine.TestTools.TestPlatform.PlayMode, selection, TextWriter.Null);
            Assert.That((result.Passed, result.Failed), Is.EqualTo((play == 1 ? 9 : 1, 0)));
            Assert.That(s_Plays, Is.EqualTo(play));
        }
    }

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
    static void CountPlays() => s_Plays++;
}
