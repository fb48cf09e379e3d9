using System.Collections.Generic;

namespace UnityEditor;

/// <summary>Preferences by key. They live as long as the process here; Unity keeps them on the machine.</summary>
public sealed class EditorPrefs
{
    static readonly Dictionary<string, object> s_Values = new();

    public static void SetBool(string key, bool value) => s_Values[key] = value;
    public static bool GetBool(string key) => GetBool(key, false);
    public static bool GetBool(string key, bool defaultValue) => s_Values.GetValueOrDefault(key) is bool value ? value : defaultValue;
    public static void SetInt(string key, int value) => s_Values[key] = value;
    public static int GetInt(string key) => GetInt(key, 0);
    public static int GetInt(string key, int defaultValue) => s_Values.GetValueOrDefault(key) is int value ? value : defaultValue;
    public static void SetFloat(string key, float value) => s_Values[key] = value;
    public static float GetFloat(string key) => GetFloat(key, 0f);
    public static float GetFloat(string key, float defaultValue) => s_Values.GetValueOrDefault(key) is float value ? value : defaultValue;
    public static void SetString(string key, string value) => s_Values[key] = value;
    public static string GetString(string key) => GetString(key, "");
    public static string GetString(string key, string defaultValue) => s_Values.GetValueOrDefault(key) as string ?? defaultValue;
    public static bool HasKey(string key) => s_Values.ContainsKey(key);
    public static void DeleteKey(string key) => s_Values.Remove(key);
    public static void DeleteAll() => s_Values.Clear();
}
