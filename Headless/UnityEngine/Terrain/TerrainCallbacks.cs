namespace UnityEngine;

public static class TerrainCallbacks
{
    public delegate void HeightmapChangedCallback(Terrain terrain, RectInt heightRegion, bool synched);
    public delegate void TextureChangedCallback(Terrain terrain, string textureName, RectInt texelRegion, bool synched);

    public static event HeightmapChangedCallback? heightmapChanged;
    public static event TextureChangedCallback? textureChanged;

    internal static void RaiseHeightmap(Terrain terrain, RectInt region) => heightmapChanged?.Invoke(terrain, region, true);
    internal static void RaiseTexture(Terrain terrain, string name, RectInt region) => textureChanged?.Invoke(terrain, name, region, true);
}
