using UnityEngine.Scripting;

// No scene and no assembly refers to this one: without the attribute players leave it out from stripping level Low on, and with it
// UniversalSceneTextures.Register, which [RuntimeInitializeOnLoadMethod] itself preserves once the assembly is there.
[assembly: AlwaysLinkAssembly]
