using System;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Project assets by path ("Assets/..." or "Packages/...") and GUID.</summary>
interface IAssetDatabase
{
    Object? LoadMain(string path);
    Object? Load(string path, Type type);
    Object[] LoadAll(string path);
    string GuidToPath(string guid);
    string PathToGuid(string path);
    string PathOf(Object asset);
    string[] Find(string filter, string[]? folders);
}
