using System.Collections;
using UnityEditor;

namespace UnityEngine.TestTools;

/// <summary>Yield it in an EditMode test to leave the play mode that <see cref="EnterPlayMode"/> entered.</summary>
public class ExitPlayMode : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload => false;
    public bool ExpectedPlaymodeState => false;

    public IEnumerator Perform()
    {
        if (!EditorApplication.isPlaying) throw new InvalidOperationException("Editor is already in EditMode");
        EditorApplication.ExitPlaymode();
        yield return null;
    }
}
