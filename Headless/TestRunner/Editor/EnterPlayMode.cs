using System.Collections;
using UnityEditor;

namespace UnityEngine.TestTools;

/// <summary>Yield it in an EditMode test to go on in play mode. Scripts are never reloaded here, whatever is expected.</summary>
public class EnterPlayMode : IEditModeTestYieldInstruction
{
    public EnterPlayMode(bool expectDomainReload = true) => ExpectDomainReload = expectDomainReload;

    public bool ExpectDomainReload { get; }
    public bool ExpectedPlaymodeState => true;

    public IEnumerator Perform()
    {
        if (EditorApplication.isPlaying) throw new InvalidOperationException("Editor is already in PlayMode");
        EditorApplication.EnterPlaymode();
        yield return null;
    }
}
