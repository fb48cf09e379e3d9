namespace UnityEngine.Rendering;

public enum ShaderKeywordType
{
    None = 0,
    BuiltinDefault = 2,
    UserDefined = 6,
    Plugin = 10,
}
