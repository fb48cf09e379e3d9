namespace UnityEngine.Rendering.Universal;

public class UniversalAdditionalCameraData : MonoBehaviour
{
    public ScriptableRenderer? scriptableRenderer => null;
}
